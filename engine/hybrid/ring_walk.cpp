#include "engine/hybrid/ring_walk.h"

#include <algorithm>
#include <cstddef>
#include <queue>
#include <tuple>
#include <utility>

#include "engine/hybrid/unique_places.h"
#include "spatial/vector.h"

namespace stream_recon {
namespace {

/// Of each point of the hole: sum of the normals of its fills.
std::vector<Point3> fill_normals(const Hole& hole) {
  std::vector<Point3> normals(hole.points.size());
  for (const HoleTriangle& fill : hole.fills) {
    const Point3& a = hole.points[fill[0]];
    const Point3 normal = cross(minus(hole.points[fill[1]], a), minus(hole.points[fill[2]], a));
    for (const std::uint32_t corner : fill) normals[corner] = plus(normals[corner], normal);
  }
  return normals;
}

double distance_to_segment(const Point3& p, const Point3& a, const Point3& b) {
  const Point3 along = minus(b, a);
  const double square = dot(along, along);
  const double share = square > 0 ? std::clamp(dot(minus(p, a), along) / square, 0.0, 1.0) : 0;
  return length(minus(p, plus(a, scaled(along, share))));
}

struct Reached {
  double cost = 0;
  std::uint32_t vertex = 0;

  friend bool operator>(const Reached& a, const Reached& b) {
    return std::tie(a.cost, a.vertex) > std::tie(b.cost, b.vertex);
  }
};

class RingWalker {
 public:
  RingWalker(const Hole& hole, const CrustMesh& crust, const RingWalkOptions& options)
      : hole_(hole),
        crust_(crust),
        options_(options),
        anchor_(hole.points.size(), kNoPlace),
        cost_(crust.points().size()),
        came_by_(crust.points().size(), kNoSide),
        seen_in_(crust.points().size(), 0) {
    walks_.sample_of.assign(crust.points().size(), kNoHolePoint);
    walks_.walked_for.assign(crust.side_count(), kNoEdge);
  }

  void find_anchors(const std::vector<std::vector<std::uint32_t>>& rings) {
    std::vector<std::uint32_t> samples;
    for (const auto& ring : rings) samples.insert(samples.end(), ring.begin(), ring.end());
    std::sort(samples.begin(), samples.end());
    samples.erase(std::unique(samples.begin(), samples.end()), samples.end());
    std::vector<Point3> points;
    points.reserve(samples.size());
    for (const std::uint32_t sample : samples) points.push_back(hole_.points[sample]);
    const std::vector<Point3> normals = fill_normals(hole_);
    const auto faces_same_way = [&](std::uint32_t sample, std::uint32_t vertex) {
      return dot(normals[samples[sample]], crust_.normal(vertex)) >= 0;
    };
    const auto places = unique_places(points, crust_.near(), faces_same_way);
    for (std::size_t i = 0; i < samples.size(); ++i) {
      if (places[i] == kNoPlace) continue;
      anchor_[samples[i]] = places[i];
      walks_.sample_of[places[i]] = samples[i];
    }
  }

  void walk(const HoleEdge& edge) {
    const std::vector<std::uint32_t> sides = way(edge);
    if (sides.empty()) {
      walks_.failed.push_back(edge);
      return;
    }
    const auto number = static_cast<std::uint32_t>(walks_.edges.size());
    walks_.edges.push_back(edge);
    double whole = 0;
    for (const std::uint32_t side : sides) whole += side_length(side);
    double gone = 0;
    for (const std::uint32_t side : sides) {
      walks_.walked_for[side] = number;
      gone += side_length(side);
      std::uint32_t& sample = walks_.sample_of[crust_.to(side)];
      if (sample == kNoHolePoint) sample = edge[gone > whole / 2 ? 1 : 0];
    }
  }

  RingWalks&& walks() && { return std::move(walks_); }

 private:
  double side_length(std::uint32_t side) const {
    return length(minus(crust_.points()[crust_.to(side)], crust_.points()[crust_.from(side)]));
  }

  /// Sides from one end to the other; none if there is no way, or it is taken.
  std::vector<std::uint32_t> way(const HoleEdge& edge) {
    std::vector<std::uint32_t> sides;
    if (anchor_[edge[0]] == kNoPlace || anchor_[edge[1]] == kNoPlace || !search(edge)) return sides;
    for (std::uint32_t v = anchor_[edge[1]]; v != anchor_[edge[0]];) {
      sides.push_back(came_by_[v]);
      v = crust_.from(came_by_[v]);
    }
    std::reverse(sides.begin(), sides.end());
    const bool is_taken = std::any_of(sides.begin(), sides.end(), [this](std::uint32_t side) {
      return walks_.walked_for[side] != kNoEdge ||
             walks_.walked_for[crust_.opposite(side)] != kNoEdge;
    });
    if (is_taken) sides.clear();
    return sides;
  }

  /// The cheapest way (Dijkstra) over vertices that are on no walk.
  bool search(const HoleEdge& edge) {
    const std::uint32_t start = anchor_[edge[0]];
    const std::uint32_t goal = anchor_[edge[1]];
    const Point3& a = hole_.points[edge[0]];
    const Point3& b = hole_.points[edge[1]];
    const double straight = options_.straightness / std::max(length(minus(b, a)), 1e-300);
    ++search_;
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> open;
    reach(start, 0, kNoSide);
    open.push({0, start});
    for (std::uint32_t seen = 0; !open.empty() && seen < options_.most_seen; ++seen) {
      const Reached at = open.top();
      open.pop();
      if (at.vertex == goal) return true;
      if (at.cost > cost_[at.vertex]) continue;
      for (const std::uint32_t side : crust_.sides_from(at.vertex)) {
        const std::uint32_t to = crust_.to(side);
        if (!crust_.is_plain(side)) continue;
        if (to != goal && walks_.sample_of[to] != kNoHolePoint) continue;
        const double aside = distance_to_segment(crust_.points()[to], a, b);
        const double cost = at.cost + side_length(side) * (1 + straight * aside);
        if (seen_in_[to] == search_ && !(cost < cost_[to])) continue;
        reach(to, cost, side);
        open.push({cost, to});
      }
    }
    return false;
  }

  void reach(std::uint32_t vertex, double cost, std::uint32_t side) {
    seen_in_[vertex] = search_;
    cost_[vertex] = cost;
    came_by_[vertex] = side;
  }

  const Hole& hole_;
  const CrustMesh& crust_;
  const RingWalkOptions options_;
  std::vector<std::uint32_t> anchor_;  ///< of points of the hole
  RingWalks walks_;
  std::vector<double> cost_;  ///< these three of vertices of the crust, in the search of seen_in_
  std::vector<std::uint32_t> came_by_;
  std::vector<std::uint32_t> seen_in_;
  std::uint32_t search_ = 0;
};

}  // namespace

RingWalks walk_rings(const Hole& hole, const std::vector<std::vector<std::uint32_t>>& rings,
                     const CrustMesh& crust, const RingWalkOptions& options) {
  RingWalker walker(hole, crust, options);
  walker.find_anchors(rings);
  for (const auto& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      walker.walk({ring[i], ring[(i + 1) % ring.size()]});
    }
  }
  return std::move(walker).walks();
}

}  // namespace stream_recon
