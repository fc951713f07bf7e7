#include "engine/hybrid/stored_hole.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "engine/hybrid/hole_crust.h"
#include "engine/hybrid/hole_search.h"
#include "engine/hybrid/outer_facets.h"
#include "engine/surface/facet_record.h"
#include "spatial/vector.h"

namespace stream_recon {
namespace {

/// A corner of a triangle of the crust.
struct Corner {
  CrustVertexName name;
  std::uint32_t at;  ///< three times the triangle, and which of its corners

  friend bool operator<(const Corner& a, const Corner& b) {
    return std::tie(a.name, a.at) < std::tie(b.name, b.at);
  }
};

/// Where a corner lies that only its name tells of: at its sample, or at the nearest that is known.
Point3 place_of(const CrustVertexName& name, const HoleCrust& triangle, const StoredHole& stored) {
  const auto at = std::lower_bound(stored.ranks.begin(), stored.ranks.end(), name.sample);
  if (at != stored.ranks.end() && *at == name.sample) {
    return stored.hole.points[static_cast<std::size_t>(at - stored.ranks.begin())];
  }
  for (const Point3& point : triangle.points) {
    if (!std::isnan(point.x)) return point;
  }
  return stored.hole.points.front();
}

}  // namespace

std::uint64_t StoredHole::bytes() const {
  return ranks.capacity() * sizeof(std::uint32_t) + records.capacity() * sizeof(HoleFill) +
         hole.points.capacity() * sizeof(Point3) + hole.fills.capacity() * sizeof(HoleTriangle) +
         crust.points.capacity() * sizeof(Point3) +
         crust.triangles.capacity() * sizeof(std::array<std::uint32_t, 3>);
}

HoleReader::HoleReader(const ScratchDirectory& scratch, bool has_surroundings)
    : fills_(scratch, kHoleFills), points_(scratch, kHolePoints) {
  if (!has_surroundings) return;
  crust_.emplace(scratch, kHoleCrust);
  outer_.emplace(scratch, kOuterFacets);
}

StoredHole HoleReader::read() {
  StoredHole stored;
  stored.number = *next();
  points_.visit(stored.number, [&](const HolePoint& point) {
    stored.ranks.push_back(point.rank);
    stored.hole.points.push_back(point.point);
  });
  fills_.visit(stored.number, [&](const HoleFill& fill) {
    HoleTriangle corners{};
    for (int i = 0; i < 3; ++i) {
      const auto at = std::lower_bound(stored.ranks.begin(), stored.ranks.end(), fill.ranks[i]);
      corners[i] = static_cast<std::uint32_t>(at - stored.ranks.begin());
    }
    if (fill.facing == static_cast<std::int8_t>(Facing::kInward)) std::swap(corners[1], corners[2]);
    stored.hole.fills.push_back(corners);
    stored.records.push_back(fill);
  });
  if (crust_) read_crust(stored);
  if (outer_) read_outer_facets(stored);
  return stored;
}

void HoleReader::skip() {
  const std::uint32_t number = *next();
  fills_.visit(number, [](const HoleFill&) {});
}

void HoleReader::read_outer_facets(StoredHole& stored) {
  std::vector<std::uint32_t> corners;
  outer_->visit(stored.number, [&](const OuterFacet& facet) {
    corners.clear();
    for (const std::uint32_t rank : facet.ranks) {
      const auto at = std::lower_bound(stored.ranks.begin(), stored.ranks.end(), rank);
      if (at == stored.ranks.end() || *at != rank) continue;
      corners.push_back(static_cast<std::uint32_t>(at - stored.ranks.begin()));
    }
    Hole& hole = stored.hole;
    if (corners.size() == 3) hole.outer_facets.push_back({corners[0], corners[1], corners[2]});
    for (std::size_t i = 0; i < corners.size(); ++i) {
      for (std::size_t k = i + 1; k < corners.size(); ++k) {
        hole.outer_edges.push_back({corners[i], corners[k]});
      }
    }
  });
}

// Corners of one name are one vertex; vertices are numbered by their names.
void HoleReader::read_crust(StoredHole& stored) {
  std::vector<Corner> corners;
  std::vector<Point3> points;
  crust_->visit(stored.number, [&](const HoleCrust& triangle) {
    for (std::size_t i = 0; i < 3; ++i) {
      corners.push_back({triangle.names[i], static_cast<std::uint32_t>(corners.size())});
      const bool is_placed = !std::isnan(triangle.points[i].x);
      points.push_back(is_placed ? triangle.points[i]
                                 : place_of(triangle.names[i], triangle, stored));
    }
  });
  std::sort(corners.begin(), corners.end());
  stored.crust.triangles.resize(corners.size() / 3);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::uint32_t at = corners[i].at;
    if (i == 0 || !(corners[i].name == corners[i - 1].name)) {
      stored.crust.points.push_back(points[at]);
    }
    stored.crust.triangles[at / 3][at % 3] =
        static_cast<std::uint32_t>(stored.crust.points.size() - 1);
  }
}

}  // namespace stream_recon
