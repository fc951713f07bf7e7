// Closed surfaces as triangles, holes cut out of them, and pieces of a crust near a hole.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <numbers>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "engine/hybrid/crust_piece.h"
#include "engine/hybrid/hole.h"
#include "spatial/vector.h"

namespace stream_recon::shapes {

using Triangle = std::array<std::uint32_t, 3>;
using Surface = CrustPiece;
using Random = std::mt19937_64;

inline Point3 unit(const Point3& p) {
  return scaled(p, 1 / length(p));
}

inline Point3 middle(const Surface& s, const Triangle& t) {
  return scaled(plus(s.points[t[0]], plus(s.points[t[1]], s.points[t[2]])), 1.0 / 3);
}

/// Of radius 1: the octahedron, each triangle in 4^levels, turned and jittered by a share of a
/// side.
inline Surface sphere(int levels, double jitter, Random& random) {
  Surface s;
  s.points = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  s.triangles = {{0, 1, 2}, {1, 3, 2}, {3, 4, 2}, {4, 0, 2},
                 {1, 0, 5}, {3, 1, 5}, {4, 3, 5}, {0, 4, 5}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto between = [&](std::uint32_t a, std::uint32_t b) {
      const auto [at, is_new] = middles.try_emplace(std::minmax({a, b}), s.points.size());
      if (is_new) s.points.push_back(unit(plus(s.points[a], s.points[b])));
      return at->second;
    };
    std::vector<Triangle> finer;
    for (const auto& [a, b, c] : s.triangles) {
      const std::uint32_t ab = between(a, b), bc = between(b, c), ca = between(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    s.triangles = finer;
  }
  std::uniform_real_distribution<double> any(-1, 1);
  const double reach = jitter * 1.2 / (1 << levels);
  const double turn = 3 * any(random);
  for (Point3& p : s.points) {
    const Point3 moved{p.x + reach * any(random), p.y + reach * any(random),
                       p.z + reach * any(random)};
    const Point3 u = unit(moved);
    const Point3 v{std::cos(turn) * u.x - std::sin(turn) * u.y,
                   std::sin(turn) * u.x + std::cos(turn) * u.y, u.z};
    p = {v.x, std::cos(turn) * v.y - std::sin(turn) * v.z,
         std::sin(turn) * v.y + std::cos(turn) * v.z};
  }
  return s;
}

/// Around the z axis, of radii 1 and 0.4; jittered by a share of a step.
inline Surface torus(std::uint32_t around, std::uint32_t across, double jitter, Random& random) {
  Surface s;
  std::uniform_real_distribution<double> any(-jitter, jitter);
  for (std::uint32_t i = 0; i < around; ++i) {
    for (std::uint32_t j = 0; j < across; ++j) {
      const double u = 2 * std::numbers::pi * (i + any(random)) / around;
      const double v = 2 * std::numbers::pi * (j + any(random)) / across;
      const double r = 1 + 0.4 * std::cos(v);
      s.points.push_back({r * std::cos(u), r * std::sin(u), 0.4 * std::sin(v)});
      const auto at = [&](std::uint32_t di, std::uint32_t dj) {
        return (i + di) % around * across + (j + dj) % across;
      };
      s.triangles.push_back({at(0, 0), at(1, 0), at(1, 1)});
      s.triangles.push_back({at(0, 0), at(1, 1), at(0, 1)});
    }
  }
  return s;
}

using Region = std::function<bool(const Point3&)>;  ///< by the middle of a triangle

inline Surface part(const Surface& s, const Region& region) {
  Surface result{s.points, {}};
  for (const Triangle& t : s.triangles) {
    if (region(middle(s, t))) result.triangles.push_back(t);
  }
  return result;
}

inline Hole hole(const Surface& s, const Region& region) {
  std::vector<Triangle> fills = part(s, region).triangles;
  std::set<std::uint32_t> used;
  for (const Triangle& t : fills) used.insert(t.begin(), t.end());
  Hole result;
  std::map<std::uint32_t, std::uint32_t> numbers;
  for (const std::uint32_t v : used) {
    numbers[v] = static_cast<std::uint32_t>(result.points.size());
    result.points.push_back(s.points[v]);
  }
  for (const Triangle& t : fills) {
    result.fills.push_back({numbers[t[0]], numbers[t[1]], numbers[t[2]]});
  }
  return result;
}

/// Triangles up the edge less those down, of every edge of which that is not 0.
inline std::map<HoleEdge, int> boundary(const std::vector<HoleTriangle>& triangles) {
  std::map<HoleEdge, int> sums;
  for (const HoleTriangle& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = t[i], b = t[(i + 1) % 3];
      sums[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
    }
  }
  std::erase_if(sums, [](const auto& sum) { return sum.second == 0; });
  return sums;
}

/// Most triangles at an edge; at an edge of the boundary counted double.
inline int most_at_an_edge(const std::vector<HoleTriangle>& triangles) {
  std::map<HoleEdge, int> counts;
  for (const HoleTriangle& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      ++counts[{std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3])}];
    }
  }
  const auto border = boundary(triangles);
  int most = 0;
  for (const auto& [edge, count] : counts) {
    most = std::max(most, border.contains(edge) ? 2 * count : count);
  }
  return most;
}

}  // namespace stream_recon::shapes
