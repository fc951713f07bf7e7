// The sheets of a solid's surface found in core, by walks through the cells around edges: no
// angles, one edge after the other, everything anew after each change.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include "engine/surface/facet_record.h"
#include "spatial/delaunay.h"

namespace stream_recon {

class SheetOracle {
 public:
  using Triangle = std::array<std::uint32_t, 3>;  ///< ranks, ascending
  using IsInside = std::function<bool(const Point3& centroid)>;

  /// \param points in the order of their ranks
  SheetOracle(const std::vector<Point3>& points, const IsInside& is_inside) : points_(points) {
    EXPECT_EQ(delaunay_.insert(points_), Delaunay::Outcome::kDone);
    inside_.resize(delaunay_.cell_slots(), false);
    for (CellId c = 0; c < delaunay_.cell_slots(); ++c) {
      if (!delaunay_.is_live(c) || delaunay_.is_infinite(c)) continue;
      Point3 centroid;
      for (const VertexId v : delaunay_.vertices(c)) {
        const Point3& p = points_[v];
        centroid = {centroid.x + p.x / 4, centroid.y + p.y / 4, centroid.z + p.z / 4};
      }
      inside_[c] = is_inside(centroid);
    }
    find_facets();
    find_edges();
    join_inside_wedges();
    for (auto& [edge, around] : edges_) part(edge, around);
    number_sheets();
  }

  const std::vector<Point3>& points() const { return points_; }

  /// As the labels hand them on.
  std::vector<FacetRecord> records() const {
    std::vector<FacetRecord> records;
    for (const Facet& facet : facets_) {
      const auto& r = facet.ranks;
      records.push_back({{r[0], r[1], r[2]}, 1, TriangleSource::kGamma, facet.facing});
    }
    return records;
  }

  /// Of each corner of each triangle.
  const std::map<Triangle, Triangle>& sheets() const { return sheets_; }

  std::uint64_t multiple_edges() const { return multiple_edges_; }
  /// Edges at which outside wedges are joined.
  std::uint64_t turned_edges() const { return turned_edges_; }

 private:
  using Edge = std::array<std::uint32_t, 2>;
  struct Facet {
    Triangle ranks;
    CellId cell;  ///< inside
    int side;
    Facing facing;
  };
  struct Around {
    std::vector<std::size_t> facets;  ///< in the order of the cells around the edge
    std::vector<bool> ends_inside;    ///< whether inside cells lie before each
    std::map<std::size_t, std::size_t> partner;
  };

  void find_facets() {
    for (CellId c = 0; c < delaunay_.cell_slots(); ++c) {
      for (int i = 0; i < 4 && inside_[c]; ++i) {
        const CellId beyond = delaunay_.neighbor(c, i);
        if (inside_[beyond]) continue;
        facets_.push_back({sorted_corners(c, i), c, i, facing_of(c, i)});
      }
    }
    std::sort(facets_.begin(), facets_.end(),
              [](const Facet& a, const Facet& b) { return a.ranks < b.ranks; });
    for (std::size_t f = 0; f < facets_.size(); ++f) number_[facets_[f].ranks] = f;
    parent_.resize(3 * facets_.size());
  }

  Triangle sorted_corners(CellId c, int side) const {
    const auto v = delaunay_.vertices(c);
    Triangle corners{};
    for (int i = 0, n = 0; i < 4; ++i) {
      if (i != side) corners[n++] = v[i];
    }
    std::sort(corners.begin(), corners.end());
    return corners;
  }

  /// By the order of the inside cell's vertices: the first three are counterclockwise seen from the
  /// fourth.
  Facing facing_of(CellId c, int side) const {
    const Triangle t = sorted_corners(c, side);
    const auto v = delaunay_.vertices(c);
    const std::array<std::uint32_t, 4> turned{t[0], t[1], t[2], v[side]};
    int inversions = 0;
    for (int i = 0; i < 4; ++i) {
      for (int j = i + 1; j < 4; ++j) {
        const auto at = [&v](std::uint32_t x) { return std::find(v.begin(), v.end(), x); };
        inversions += at(turned[i]) > at(turned[j]) ? 1 : 0;
      }
    }
    return inversions % 2 == 0 ? Facing::kInward : Facing::kOutward;
  }

  void find_edges() {
    for (std::size_t f = 0; f < facets_.size(); ++f) {
      const Triangle& t = facets_[f].ranks;
      for (const auto& [a, b] : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 2)}) {
        Around& around = edges_[{t[a], t[b]}];
        if (around.facets.empty()) walk_around(f, {t[a], t[b]}, around);
      }
    }
    multiple_edges_ = static_cast<std::uint64_t>(std::count_if(
        edges_.begin(), edges_.end(), [](const auto& e) { return e.second.facets.size() > 2; }));
  }

  /// Through all cells at the edge, from the inside cell of facet f on.
  void walk_around(std::size_t f, const Edge& edge, Around& around) const {
    const auto third_of = [&edge](const auto& vertices, std::uint32_t except) {
      for (const std::uint32_t v : vertices) {
        if (v != edge[0] && v != edge[1] && v != except) return v;
      }
      return except;
    };
    constexpr std::uint32_t kNone = ~0U;
    CellId cell = facets_[f].cell;
    std::uint32_t entered = third_of(facets_[f].ranks, kNone);
    const CellId first = cell;
    do {
      const auto v = delaunay_.vertices(cell);
      const std::uint32_t left = third_of(v, entered);
      // The facet opposite `entered` leads on; it has the edge and `left`.
      const auto side = static_cast<int>(std::find(v.begin(), v.end(), entered) - v.begin());
      const CellId next = delaunay_.neighbor(cell, side);
      if (inside_[cell] != inside_[next]) {
        Triangle ranks{edge[0], edge[1], left};
        std::sort(ranks.begin(), ranks.end());
        around.facets.push_back(number_.at(ranks));
        around.ends_inside.push_back(inside_[cell]);
      }
      entered = left;
      cell = next;
    } while (cell != first);
  }

  void join_inside_wedges() {
    for (auto& [edge, around] : edges_) {
      const std::size_t count = around.facets.size();
      ASSERT_EQ(count % 2, 0U);
      for (std::size_t i = 0; i < count; ++i) {
        const std::size_t next = (i + 1) % count;
        if (!around.ends_inside[next]) continue;
        around.partner[around.facets[i]] = around.facets[next];
        around.partner[around.facets[next]] = around.facets[i];
      }
    }
    join_all();
  }

  std::size_t corner(std::size_t f, std::uint32_t rank) const {
    const Triangle& t = facets_[f].ranks;
    return 3 * f + static_cast<std::size_t>(std::find(t.begin(), t.end(), rank) - t.begin());
  }
  std::size_t find(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  void join_all() {
    std::iota(parent_.begin(), parent_.end(), 0);
    for (const auto& [edge, around] : edges_) {
      for (const auto& [f, g] : around.partner) {
        for (const std::uint32_t end : edge) {
          const std::size_t a = find(corner(f, end));
          const std::size_t b = find(corner(g, end));
          parent_[std::max(a, b)] = std::min(a, b);
        }
      }
    }
  }

  /// Where wedges have the same sheets at both ends, the triangle at the end of each gets the next
  /// that begins one of them.
  void part(const Edge& edge, Around& around) {
    const std::size_t count = around.facets.size();
    if (count == 2) return;
    std::map<std::pair<std::size_t, std::size_t>, std::vector<std::size_t>> alike;
    for (std::size_t i = 0; i < count; ++i) {
      if (around.ends_inside[i]) continue;
      const std::size_t begin = around.facets[i];
      alike[{find(corner(begin, edge[0])), find(corner(begin, edge[1]))}].push_back(i);
    }
    bool is_turned = false;
    for (const auto& [sheets, wedges] : alike) {
      if (wedges.size() == 1) continue;
      is_turned = true;
      std::vector<std::size_t> ends;
      for (const std::size_t i : wedges) ends.push_back(around.partner[around.facets[i]]);
      for (std::size_t i = 0; i < wedges.size(); ++i) {
        const std::size_t begin = around.facets[wedges[(i + 1) % wedges.size()]];
        around.partner[ends[i]] = begin;
        around.partner[begin] = ends[i];
      }
    }
    if (!is_turned) return;
    ++turned_edges_;
    join_all();
  }

  void number_sheets() {
    std::map<std::uint32_t, std::map<std::size_t, std::uint32_t>> of_vertex;
    for (std::size_t f = 0; f < facets_.size(); ++f) {
      Triangle sheets{};
      for (int i = 0; i < 3; ++i) {
        auto& known = of_vertex[facets_[f].ranks[i]];
        const auto next = static_cast<std::uint32_t>(known.size());
        sheets[i] = known.try_emplace(find(3 * f + i), next).first->second;
      }
      sheets_[facets_[f].ranks] = sheets;
    }
  }

  std::vector<Point3> points_;
  Delaunay delaunay_;
  std::vector<bool> inside_;
  std::vector<Facet> facets_;  ///< ascending
  std::map<Triangle, std::size_t> number_;
  std::map<Edge, Around> edges_;
  std::vector<std::size_t> parent_;  ///< of corners
  std::map<Triangle, Triangle> sheets_;
  std::uint64_t multiple_edges_ = 0;
  std::uint64_t turned_edges_ = 0;
};

}  // namespace stream_recon
