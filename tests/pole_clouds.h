// A cloud with far points, ordered and indexed, and its poles with any labels: what the windows of
// the power diagram are made from, found in core by a plain search.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "engine/order/hilbert_sort.h"
#include "engine/order/ingest.h"
#include "engine/order/point_store.h"
#include "engine/poles/pole_store.h"
#include "engine/windows/cloud_index.h"
#include "spatial/cell_view.h"
#include "spatial/circumball.h"
#include "spatial/delaunay.h"
#include "spatial/vector.h"
#include "tests/engine_fixture.h"

namespace stream_recon {

/// Ranks of a Delaunay cell, ascending; that of the infinite point comes last.
using CellRanks = std::array<std::uint64_t, 4>;
inline constexpr std::uint64_t kInfiniteRank = ~std::uint64_t{0};

class PoleCloud {
 public:
  using IsInside = std::function<bool(const Point3& centre)>;

  PoleCloud(const std::vector<Point3>& samples, const IsInside& is_inside) {
    const std::string path = stage.folder / "cloud.f64";
    put_bytes(path,
              {reinterpret_cast<const char*>(samples.data()), samples.size() * sizeof(Point3)});
    const CloudSummary cloud = ingest(
        {.inputs = {path}, .format = InputFormat::kF64, .adds_far_points = true}, stage.context);
    const OrderResult order = hilbert_sort(cloud, stage.context);
    index = build_index(cloud, order.point_count, stage.context);
    read_points(cloud.points);
    EXPECT_EQ(delaunay_.insert(points), Delaunay::Outcome::kDone);
    find_poles();
    store_poles(is_inside);
  }

  /// All cells of the whole cloud, infinite ones too.
  std::set<CellRanks> cells() const {
    std::set<CellRanks> all;
    const CellView view = delaunay_.view();
    for (CellId c = 0; c < view.slots(); ++c) {
      if (!view.is_live(c)) continue;
      CellRanks ranks;
      for (int i = 0; i < 4; ++i) {
        const VertexId v = view.vertex(c, i);
        ranks[i] = v == Delaunay::kInfinite ? kInfiniteRank : v;
      }
      std::sort(ranks.begin(), ranks.end());
      all.insert(ranks);
    }
    return all;
  }

  StageFixture stage;
  CloudIndex index;
  std::vector<Point3> points;  ///< by rank, far points too
  std::vector<Pole> poles;     ///< as stored

 private:
  void read_points(std::uint64_t samples) {
    PointStoreReader reader(stage.scratch, kPointStore);
    std::vector<StoredPoint> stored(index.point_count);
    EXPECT_EQ(reader.read(stored), stored.size());
    for (const StoredPoint& s : stored) {
      points.push_back(s.point);
      is_sample_.push_back(s.input_index < samples);
    }
  }

  bool is_tetrahedron(CellId c) const { return delaunay_.is_live(c) && !delaunay_.is_infinite(c); }

  /// Corners in the order of their ranks, so that roundings depend on the cloud alone.
  Pole pole_of(CellId c) const {
    auto v = delaunay_.vertices(c);
    std::sort(v.begin(), v.end());
    const Circumball ball = circumball({points[v[0]], points[v[1]], points[v[2]], points[v[3]]});
    Pole pole;
    pole.tetrahedron.ranks = {v[0], v[1], v[2], v[3]};
    pole.centre = plus(ball.origin, ball.centre);
    pole.radius = ball.radius();
    return pole;
  }

  /// Of every sample the farthest centre, and the farthest of those on the other side of it.
  void find_poles() {
    std::vector<Pole> first(points.size());
    std::vector<Pole> second(points.size());
    for (std::vector<Pole>* farthest : {&first, &second}) {
      for (CellId c = 0; c < delaunay_.cell_slots(); ++c) {
        if (!is_tetrahedron(c)) continue;
        const Pole pole = pole_of(c);
        for (const VertexId v : delaunay_.vertices(c)) {
          const Point3 to = minus(pole.centre, points[v]);
          const bool is_other_side =
              farthest == &first || dot(to, minus(first[v].centre, points[v])) < 0;
          if (is_other_side && pole.radius > (*farthest)[v].radius) (*farthest)[v] = pole;
        }
      }
    }
    for (VertexId v = 0; v < points.size(); ++v) {
      if (!is_sample_[v]) continue;
      for (const Pole& pole : {first[v], second[v]}) {
        if (pole.radius > 0) poles.push_back(pole);
      }
    }
  }

  /// Each ball once, as engine/poles/pole_stage.h does.
  void store_poles(const IsInside& is_inside) {
    using Ball = std::tuple<double, double, double, double>;
    std::map<Ball, NodeKey> lowest;
    const auto ball_of = [](const Pole& p) {
      return Ball{p.centre.x, p.centre.y, p.centre.z, p.radius};
    };
    for (const Pole& pole : poles) {
      NodeKey& name = lowest.try_emplace(ball_of(pole), pole.tetrahedron).first->second;
      name = std::min(name, pole.tetrahedron);
    }
    std::vector<Pole> distinct;
    std::map<NodeKey, Pole> by_name;
    for (const Pole& pole : poles) {
      if (lowest.at(ball_of(pole)) == pole.tetrahedron) by_name.emplace(pole.tetrahedron, pole);
    }
    poles.clear();
    for (auto& [name, pole] : by_name) {
      pole.is_inside = is_inside(pole.centre) ? 1 : 0;
      poles.push_back(pole);
    }
    auto store = create_records<Pole>(stage.scratch, kPoleStore, kPoleStoreBlock);
    store.append(std::span<const Pole>(poles));
    store.finish();
  }

  std::vector<bool> is_sample_;
  Delaunay delaunay_;
};

}  // namespace stream_recon
