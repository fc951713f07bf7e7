#include "engine/hybrid/merged_patch.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <queue>
#include <tuple>
#include <utility>

#include "engine/hybrid/ring_walk.h"
#include "engine/hybrid/unique_places.h"
#include "spatial/neighbors.h"
#include "spatial/vector.h"

namespace stream_recon {
namespace {

/// An offer of a sample to a vertex beside its part.
struct Offer {
  double squared_distance = 0;
  std::uint32_t vertex = 0;
  std::uint32_t sample = 0;

  friend bool operator>(const Offer& a, const Offer& b) {
    return std::tie(a.squared_distance, a.vertex, a.sample) >
           std::tie(b.squared_distance, b.vertex, b.sample);
  }
};

double mean_side(const Hole& hole) {
  double sum = 0;
  for (const HoleTriangle& fill : hole.fills) {
    for (std::size_t i = 0; i < 3; ++i) {
      sum += length(minus(hole.points[fill[(i + 1) % 3]], hole.points[fill[i]]));
    }
  }
  return sum / static_cast<double>(3 * hole.fills.size());
}

class RegionMerge {
 public:
  RegionMerge(const Hole& hole, const CrustMesh& crust, const std::vector<std::uint32_t>& region,
              std::vector<std::uint32_t> sample_of, const MergeOptions& options)
      : hole_(hole),
        crust_(crust),
        region_(region),
        options_(options),
        sample_of_(std::move(sample_of)) {}

  std::vector<HoleTriangle> run() {
    list_vertices();
    attract();
    plant();
    grow();
    std::vector<HoleTriangle> image;
    image.reserve(region_.size());
    for (const std::uint32_t t : region_) {
      const auto& c = crust_.triangles()[t];
      image.push_back({sample_of_[c[0]], sample_of_[c[1]], sample_of_[c[2]]});
    }
    return reduced_chain(image);
  }

 private:
  void list_vertices() {
    for (const std::uint32_t t : region_) {
      for (const std::uint32_t v : crust_.triangles()[t]) vertices_.push_back(v);
    }
    std::sort(vertices_.begin(), vertices_.end());
    vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
    is_inner_sample_.assign(hole_.points.size(), true);
    for (const std::uint32_t sample : sample_of_) {
      if (sample != kNoHolePoint) is_inner_sample_[sample] = false;
    }
    for (const std::uint32_t v : vertices_) {
      if (sample_of_[v] == kNoHolePoint) free_.push_back(v);
    }
  }

  void attract() {
    AttractionOptions attraction = options_.attraction;
    attraction.unit *= std::max(mean_side(hole_), 1e-300);
    const Neighbors samples(hole_.points);
    std::vector<Point3> near;
    for (const std::uint32_t v : free_) {
      near.clear();
      for (const Neighbor& n : samples.nearest(crust_.points()[v], options_.attracting)) {
        near.push_back(hole_.points[n.index]);
      }
      places_.push_back(attracted(crust_.points()[v], near, attraction).place);
    }
  }

  void plant() {
    std::vector<std::uint32_t> samples;
    std::vector<Point3> points;
    for (std::uint32_t sample = 0; sample < hole_.points.size(); ++sample) {
      if (!is_inner_sample_[sample]) continue;
      samples.push_back(sample);
      points.push_back(hole_.points[sample]);
    }
    const auto seeds = unique_places(points, Neighbors(places_), [](auto, auto) { return true; });
    for (std::size_t i = 0; i < samples.size(); ++i) {
      if (seeds[i] != kNoPlace) sample_of_[free_[seeds[i]]] = samples[i];
    }
  }

  void grow() {
    is_in_region_.assign(crust_.triangles().size(), false);
    for (const std::uint32_t t : region_) is_in_region_[t] = true;
    for (const std::uint32_t v : vertices_) {
      if (sample_of_[v] != kNoHolePoint) offer_around(v);
    }
    while (!offers_.empty()) {
      const Offer best = offers_.top();
      offers_.pop();
      if (sample_of_[best.vertex] != kNoHolePoint) continue;
      sample_of_[best.vertex] = best.sample;
      offer_around(best.vertex);
    }
  }

  void offer_around(std::uint32_t vertex) {
    for (const std::uint32_t side : crust_.sides_from(vertex)) {
      if (!is_in_region_[side / 3]) continue;
      offer(crust_.to(side), sample_of_[vertex]);
      offer(crust_.to(next_side(side)), sample_of_[vertex]);
    }
  }

  void offer(std::uint32_t vertex, std::uint32_t sample) {
    if (sample_of_[vertex] != kNoHolePoint) return;
    const auto place = std::lower_bound(free_.begin(), free_.end(), vertex) - free_.begin();
    const Point3 d = minus(places_[static_cast<std::size_t>(place)], hole_.points[sample]);
    offers_.push({dot(d, d), vertex, sample});
  }

  const Hole& hole_;
  const CrustMesh& crust_;
  const std::vector<std::uint32_t>& region_;
  const MergeOptions options_;
  std::vector<std::uint32_t> sample_of_;
  std::vector<bool> is_inner_sample_;    ///< no walk has it
  std::vector<std::uint32_t> vertices_;  ///< of the region, ascending
  std::vector<std::uint32_t> free_;      ///< of these: on no walk
  std::vector<Point3> places_;           ///< of free_, attracted
  std::vector<bool> is_in_region_;       ///< of triangles
  std::priority_queue<Offer, std::vector<Offer>, std::greater<>> offers_;
};

}  // namespace

std::vector<HoleTriangle> merged_patch(const Hole& hole, const CrustMesh& crust,
                                       const std::vector<std::uint32_t>& region,
                                       std::vector<std::uint32_t> sample_of,
                                       const MergeOptions& options) {
  return RegionMerge(hole, crust, region, std::move(sample_of), options).run();
}

std::vector<HoleTriangle> reduced_chain(const std::vector<HoleTriangle>& triangles) {
  std::vector<std::pair<HoleTriangle, int>> signed_triangles;
  for (HoleTriangle t : triangles) {
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    const bool is_even = t[1] < t[2];
    if (!is_even) std::swap(t[1], t[2]);
    signed_triangles.emplace_back(t, is_even ? 1 : -1);
  }
  std::sort(signed_triangles.begin(), signed_triangles.end());
  std::vector<HoleTriangle> chain;
  for (std::size_t first = 0; first < signed_triangles.size();) {
    HoleTriangle t = signed_triangles[first].first;
    int sum = 0;
    std::size_t end = first;
    for (; end < signed_triangles.size() && signed_triangles[end].first == t; ++end) {
      sum += signed_triangles[end].second;
    }
    first = end;
    if (sum < 0) std::swap(t[1], t[2]);
    chain.insert(chain.end(), static_cast<std::size_t>(std::abs(sum)), t);
  }
  return chain;
}

}  // namespace stream_recon
