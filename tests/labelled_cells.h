// A solid as some of the Delaunay cells of a cloud, and what is known of its surface in core: by
// walks through cells, without angles, so that the assembly has an oracle.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "engine/surface/facet_record.h"
#include "spatial/delaunay.h"
#include "spatial/vector.h"

namespace stream_recon {

class LabelledCells {
 public:
  using IsInside = std::function<bool(const Point3& centroid)>;

  /// \param points in the order of their ranks, spatially coherent or not
  LabelledCells(std::vector<Point3> points, const IsInside& is_inside)
      : points_(std::move(points)) {
    EXPECT_EQ(delaunay_.insert(points_), Delaunay::Outcome::kDone);
    inside_.resize(delaunay_.cell_slots(), false);
    for (CellId c = 0; c < delaunay_.cell_slots(); ++c) {
      if (!delaunay_.is_live(c) || delaunay_.is_infinite(c)) continue;
      Point3 centroid;
      for (const VertexId v : delaunay_.vertices(c)) centroid = plus(centroid, points_[v]);
      inside_[c] = is_inside(scaled(centroid, 0.25));
      if (inside_[c]) volume_ += cell_volume(c);
    }
    for (CellId c = 0; c < delaunay_.cell_slots(); ++c) {
      for (int i = 0; i < 4 && inside_[c]; ++i) {
        if (inside_[delaunay_.neighbor(c, i)]) continue;
        number_[{c, i}] = facets_.size();
        facets_.push_back({c, i});
      }
    }
  }

  struct Facts {
    std::uint64_t components = 0;
    std::uint64_t cavities = 0;
    std::int64_t genus = 0;
    double volume = 0;
    double area = 0;
    std::uint64_t vertices = 0;
    std::uint64_t nonmanifold_edges = 0;
  };

  Facts facts() const {
    Facts facts;
    facts.volume = volume_;
    std::vector<std::size_t> sheet(facets_.size());
    std::vector<std::size_t> fan(3 * facets_.size());
    std::iota(sheet.begin(), sheet.end(), 0);
    std::iota(fan.begin(), fan.end(), 0);
    std::map<std::array<VertexId, 2>, int> edges;
    std::set<VertexId> vertices;
    for (std::size_t f = 0; f < facets_.size(); ++f) {
      const auto v = corners(f);
      vertices.insert(v.begin(), v.end());
      facts.area +=
          length(cross(minus(points_[v[1]], points_[v[0]]), minus(points_[v[2]], points_[v[0]]))) /
          2;
      for (int side = 0; side < 3; ++side) {
        const VertexId a = v[side];
        const VertexId b = v[(side + 1) % 3];
        ++edges[{std::min(a, b), std::max(a, b)}];
        const std::size_t partner = across(f, a, b);
        join(sheet, f, partner);
        join(fan, corner(f, a), corner(partner, a));
        join(fan, corner(f, b), corner(partner, b));
      }
    }
    facts.vertices = vertices.size();
    for (const auto& [edge, uses] : edges) facts.nonmanifold_edges += uses > 2 ? 1 : 0;
    std::map<std::size_t, long double> volumes;
    for (std::size_t f = 0; f < facets_.size(); ++f) volumes[find(sheet, f)] += six_volumes(f);
    for (const auto& [root, volume] : volumes) ++(volume < 0 ? facts.cavities : facts.components);
    std::set<std::size_t> fans;
    for (std::size_t c = 0; c < fan.size(); ++c) fans.insert(find(fan, c));
    const auto euler =
        static_cast<std::int64_t>(fans.size()) - static_cast<std::int64_t>(facets_.size() / 2);
    facts.genus = static_cast<std::int64_t>(volumes.size()) - euler / 2;
    return facts;
  }

  const std::vector<Point3>& points() const { return points_; }

  /// As the labels hand them on.
  std::vector<FacetRecord> records() const {
    std::vector<FacetRecord> records;
    for (std::size_t f = 0; f < facets_.size(); ++f) {
      const auto v = corners(f);
      FacetRecord& record = records.emplace_back();
      record.ranks = {v[0], v[1], v[2]};
      std::sort(record.ranks.begin(), record.ranks.end());
      const auto lowest = std::min_element(v.begin(), v.end()) - v.begin();
      const bool ascends = v[(lowest + 1) % 3] < v[(lowest + 2) % 3];
      record.facing = ascends ? Facing::kOutward : Facing::kInward;
      record.delta = static_cast<float>(f % 170);
      record.source = f % 3 == 0 ? TriangleSource::kFill : TriangleSource::kGamma;
      record.closure = closure_code(static_cast<float>(f % 9));
    }
    return records;
  }

 private:
  struct Facet {
    CellId cell;
    int side;
    friend auto operator<=>(const Facet&, const Facet&) = default;
  };

  /// Counterclockwise seen from outside.
  std::array<VertexId, 3> corners(std::size_t f) const {
    constexpr int kOthers[4][3] = {{1, 3, 2}, {0, 2, 3}, {0, 3, 1}, {0, 1, 2}};
    const auto v = delaunay_.vertices(facets_[f].cell);
    const auto& o = kOthers[facets_[f].side];
    // The first three of a cell are counterclockwise seen from the fourth.
    return {v[o[0]], v[o[2]], v[o[1]]};
  }

  std::size_t corner(std::size_t f, VertexId v) const {
    const auto c = corners(f);
    return 3 * f + static_cast<std::size_t>(std::find(c.begin(), c.end(), v) - c.begin());
  }

  int index_of(CellId cell, VertexId v) const {
    const auto all = delaunay_.vertices(cell);
    return static_cast<int>(std::find(all.begin(), all.end(), v) - all.begin());
  }

  /// The facet that bounds the same inside around the edge a b: through the cells between.
  std::size_t across(std::size_t f, VertexId a, VertexId b) const {
    CellId cell = facets_[f].cell;
    VertexId left = 0;  // the third corner of the facet that was crossed last
    for (const VertexId v : corners(f)) left = v != a && v != b ? v : left;
    for (;;) {
      const int side = index_of(cell, left);
      const CellId next = delaunay_.neighbor(cell, side);
      if (!inside_[next]) return number_.at({cell, side});
      for (const VertexId v : delaunay_.vertices(cell)) {
        if (v == a || v == b || v == left) continue;
        left = v;
        break;
      }
      cell = next;
    }
  }

  static std::size_t find(std::vector<std::size_t>& parent, std::size_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  }
  static void join(std::vector<std::size_t>& parent, std::size_t a, std::size_t b) {
    parent[find(parent, a)] = find(parent, b);
  }

  long double six_volumes(std::size_t f) const {
    const auto v = corners(f);
    const auto [p, q, r] = std::array{points_[v[0]], points_[v[1]], points_[v[2]]};
    const auto minor = [](long double a, long double b, long double c, long double d) {
      return a * d - b * c;
    };
    return p.x * minor(q.y, q.z, r.y, r.z) + p.y * minor(q.z, q.x, r.z, r.x) +
           p.z * minor(q.x, q.y, r.x, r.y);
  }

  double cell_volume(CellId c) const {
    const auto v = delaunay_.vertices(c);
    const Point3& o = points_[v[3]];
    return std::abs(dot(minus(points_[v[0]], o),
                        cross(minus(points_[v[1]], o), minus(points_[v[2]], o)))) /
           6;
  }

  std::vector<Point3> points_;
  Delaunay delaunay_;
  std::vector<bool> inside_;
  std::vector<Facet> facets_;
  std::map<Facet, std::size_t> number_;
  double volume_ = 0;
};

/// The points of an n x n x n lattice of unit steps, shuffled.
inline std::vector<Point3> lattice_points(int n, std::uint64_t seed) {
  std::vector<Point3> points;
  for (int i = 0; i < n * n * n; ++i) {
    points.push_back({static_cast<double>(i % n), static_cast<double>(i / n % n),
                      static_cast<double>(i / n / n)});
  }
  std::shuffle(points.begin(), points.end(), std::mt19937_64(seed));
  return points;
}

/// Unit cubes of the lattice, by their lowest corners.
using Voxels = std::set<std::array<int, 3>>;

inline LabelledCells voxel_solid(const Voxels& voxels, int n, std::uint64_t seed = 1) {
  return LabelledCells(lattice_points(n, seed), [&voxels](const Point3& p) {
    return voxels.count({static_cast<int>(p.x), static_cast<int>(p.y), static_cast<int>(p.z)}) != 0;
  });
}

}  // namespace stream_recon
