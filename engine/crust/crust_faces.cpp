#include "engine/crust/crust_faces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>

#include "spatial/cell_view.h"
#include "spatial/orthosphere.h"
#include "spatial/vector.h"

namespace stream_recon {
namespace {

constexpr std::uint32_t kUnnumbered = std::numeric_limits<std::uint32_t>::max();

/// Of a cell with positive orientation: (i, j, k, l) is an even permutation for each row (i, j, k).
constexpr std::array<std::array<int, 4>, 12> kEven{{{0, 1, 2, 3},
                                                    {0, 2, 3, 1},
                                                    {0, 3, 1, 2},
                                                    {1, 0, 3, 2},
                                                    {1, 2, 0, 3},
                                                    {1, 3, 2, 0},
                                                    {2, 0, 1, 3},
                                                    {2, 1, 3, 0},
                                                    {2, 3, 0, 1},
                                                    {3, 0, 2, 1},
                                                    {3, 1, 0, 2},
                                                    {3, 2, 1, 0}}};

/// Degrees.
float ball_angle(const WeightedPoint3& a, const WeightedPoint3& b) {
  const Point3 d = minus(a.point, b.point);
  const double cosine =
      (dot(d, d) - a.weight - b.weight) / (2 * std::sqrt(a.weight) * std::sqrt(b.weight));
  return static_cast<float>(std::acos(std::clamp(cosine, -1.0, 1.0)) * (180 / std::numbers::pi));
}

/// The sample that most of the poles touch; of several the lowest. Points that are no samples are
/// taken only if there is nothing else.
std::uint32_t commonest(std::array<std::uint32_t, 16> samples,
                        std::span<const std::uint32_t> far_ranks) {
  std::sort(samples.begin(), samples.end());
  std::uint32_t best = samples[0];
  std::size_t most = 0;
  for (std::size_t first = 0; first < samples.size();) {
    std::size_t end = first;
    while (end < samples.size() && samples[end] == samples[first]) ++end;
    const bool is_far = std::binary_search(far_ranks.begin(), far_ranks.end(), samples[first]);
    if (!is_far && end - first > most) {
      most = end - first;
      best = samples[first];
    }
    first = end;
  }
  return best;
}

class CrustExtraction {
 public:
  CrustExtraction(const PowerWindow& power, const CrustFacesOptions& options, CrustSink& sink)
      : options_(options),
        sink_(sink),
        poles_(power.poles()),
        samples_(power.samples().view()),
        cells_(power.triangulation().view()),
        numbers_(cells_.slots(), kUnnumbered) {
    names_.reserve(poles_.owned_count() * kCrustVerticesAPole);
  }

  CrustFacesCounts run() {
    for (CellId cell = 0; cell < cells_.slots(); ++cell) {
      if (!cells_.is_live(cell)) continue;
      const auto v = cells_.vertices(cell);
      if (std::min(std::min(v[0], v[1]), std::min(v[2], v[3])) >= poles_.owned_count()) continue;
      for (const auto& [a, b, c, d] : kEven) {
        if (v[a] < poles_.owned_count() && is_outside(v[b])) add_face(cell, {a, b, c, d});
      }
    }
    return counts_;
  }

 private:
  using Corners = std::array<int, 4>;  ///< of a cell: the edge's two, then the other two

  bool is_outside(VertexId pole) const {
    return pole != RegularTriangulation::kInfinite && !poles_[pole].is_inside;
  }

  int corner(CellId cell, VertexId v) const {
    for (int i = 0; i < 3; ++i) {
      if (cells_.vertex(cell, i) == v) return i;
    }
    return 3;
  }

  /// Goes around the edge; only from the ring's lowest cell.
  void add_face(CellId first, const Corners& at) {
    // Most cells see at once that the ring has a lower one.
    if (cells_.neighbor(first, at[2]) < first || cells_.neighbor(first, at[3]) < first) return;
    const VertexId inside = cells_.vertex(first, at[0]);
    const VertexId outside = cells_.vertex(first, at[1]);
    ring_.clear();
    CellId cell = first;
    VertexId kept = cells_.vertex(first, at[2]);
    int crossed = at[3];
    bool is_bounded = true;
    do {
      if (cell < first) return;
      is_bounded = is_bounded && !cells_.is_infinite(cell);
      ring_.push_back(cell);
      const CellId next = cells_.neighbor(cell, crossed);
      const int entered = cells_.mirror_index(cell, crossed);
      crossed = corner(next, kept);
      kept = cells_.vertex(next, entered);
      cell = next;
    } while (cell != first);
    ++counts_.faces;
    if (!is_bounded) {
      ++counts_.unbounded;
      return;
    }
    add_polygon(ball_angle(cells_.point(inside), cells_.point(outside)));
  }

  void add_polygon(float delta) {
    polygon_.clear();
    for (const CellId cell : ring_) {
      const std::uint32_t vertex = dual_vertex(cell);
      if (polygon_.empty() || polygon_.back() != vertex) polygon_.push_back(vertex);
    }
    while (polygon_.size() > 1 && polygon_.back() == polygon_.front()) polygon_.pop_back();
    if (polygon_.size() < 3) return;
    const auto lowest = std::min_element(
        polygon_.begin(), polygon_.end(),
        [this](std::uint32_t a, std::uint32_t b) { return names_[a] < names_[b]; });
    std::rotate(polygon_.begin(), lowest, polygon_.end());
    triangles_.clear();
    for (std::size_t i = 1; i + 1 < polygon_.size(); ++i) {
      const std::array<std::uint32_t, 3> corners{polygon_[0], polygon_[i + 1], polygon_[i]};
      if (corners[1] == corners[0] || corners[2] == corners[0]) continue;
      triangles_.push_back({corners, delta});
    }
    if (!triangles_.empty()) sink_.take_face(triangles_);
  }

  std::uint32_t dual_vertex(CellId cell) {
    if (numbers_[cell] != kUnnumbered) return numbers_[cell];
    const auto v = cells_.vertices(cell);
    const auto sample = poles_.common_sample(v);
    return numbers_[cell] = sample ? sample_vertex(*sample) : new_vertex(v);
  }

  std::uint32_t sample_vertex(VertexId sample) {
    if (of_sample_.size() <= sample) of_sample_.resize(sample + 1, kUnnumbered);
    if (of_sample_[sample] == kUnnumbered) {
      CrustVertex vertex;
      vertex.name.sample = static_cast<std::uint32_t>(samples_.rank(sample));
      vertex.point = samples_.delaunay().view().point(sample);
      of_sample_[sample] = add(vertex);
    }
    return of_sample_[sample];
  }

  std::uint32_t new_vertex(std::array<VertexId, 4> v) {
    std::sort(v.begin(), v.end(),
              [this](VertexId a, VertexId b) { return poles_[a].number < poles_[b].number; });
    CrustVertex vertex;
    std::array<std::uint32_t, 16> touched;
    std::array<WeightedPoint3, 4> sites;
    for (int i = 0; i < 4; ++i) {
      vertex.name.poles[i] = poles_[v[i]].number;
      std::copy(poles_[v[i]].name.ranks.begin(), poles_[v[i]].name.ranks.end(),
                &touched[std::size_t{4} * i]);
      sites[i] = cells_.point(v[i]);
    }
    vertex.name.sample = commonest(touched, options_.far_ranks);
    vertex.point = orthocentre(sites);
    vertex.is_astray = is_astray(vertex.point, sites) ? 1 : 0;
    return add(vertex);
  }

  /// Four poles nearly in a plane: only roundings say where on a line their corner is. Others lie
  /// in the balls, or beside them by much less than a radius.
  static bool is_astray(const Point3& corner, const std::array<WeightedPoint3, 4>& sites) {
    double least = sites[0].weight;
    for (const WeightedPoint3& site : sites) least = std::min(least, site.weight);
    return std::any_of(sites.begin(), sites.end(), [&](const WeightedPoint3& site) {
      const Point3 d = minus(corner, site.point);
      return !(dot(d, d) - site.weight <= least);
    });
  }

  std::uint32_t add(CrustVertex& vertex) {
    const auto number = static_cast<std::uint32_t>(names_.size());
    vertex.window = options_.window;
    vertex.position = number;
    sink_.take_vertex(vertex);
    names_.push_back(vertex.name);
    ++counts_.vertices;
    return number;
  }

  const CrustFacesOptions options_;
  CrustSink& sink_;
  const SamplePoles& poles_;
  const FinalWindow samples_;
  const WeightedCellView cells_;
  std::vector<std::uint32_t> numbers_;    ///< of the vertices dual to cells
  std::vector<std::uint32_t> of_sample_;  ///< of samples that are vertices
  std::vector<CellId> ring_;
  std::vector<std::uint32_t> polygon_;
  std::vector<CrustTriangle> triangles_;  ///< of the polygon
  std::vector<CrustVertexName> names_;    ///< of vertices
  CrustFacesCounts counts_;
};

}  // namespace

CrustFacesCounts write_crust_faces(const PowerWindow& power, const CrustFacesOptions& options,
                                   CrustSink& sink) {
  return CrustExtraction(power, options, sink).run();
}

std::uint64_t crust_faces_memory(const PowerWindow& power) {
  const std::uint64_t owned = power.poles().owned_count();
  const std::uint64_t numbers =
      power.triangulation().cell_slots() + power.samples().view().delaunay().vertex_count();
  return owned * kCrustVerticesAPole * sizeof(CrustVertexName) + numbers * sizeof(std::uint32_t);
}

}  // namespace stream_recon
