// The kernel behind Delaunay and RegularTriangulation: sites inserted one at a time.
//
// Guarantees: as delaunay.h and regular_triangulation.h say. Inside, vertex v of the caller is
// v + 1, and coordinates are multiplied by scale, the power of two that makes the predicates exact
// (1 unless the cloud's numbers are extreme).
// Memory: 32 bytes a cell, a site and a byte for its label, a bit more where sites may be hidden.
// Thread rule: one writer; const access from many.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "spatial/cell_array.h"
#include "spatial/cell_view.h"
#include "spatial/conflict_zone.h"
#include "spatial/coordinate_range.h"
#include "spatial/delaunay.h"
#include "spatial/first_simplex.h"
#include "spatial/growable_array.h"
#include "spatial/hidden_vertices.h"
#include "spatial/predicates.h"
#include "spatial/site_tests.h"
#include "spatial/star_builder.h"

namespace stream_recon::detail {

/// \tparam Site Point3 or WeightedPoint3
template <class Site>
class IncrementalKernel {
 public:
  using Outcome = Delaunay::Outcome;

  explicit IncrementalKernel(const Delaunay::Options& options)
      : max_bytes_(options.max_bytes), range_(options.range) {}

  void set_max_bytes(std::size_t max_bytes) { max_bytes_ = max_bytes; }
  Outcome insert(std::span<const Site> added);
  bool in_conflict(CellId c, const Site& site) const {
    return is_in_conflict(cells_[c], sites_.data(), scaled(site, scale_), exact_);
  }

  int dimension() const { return dimension_; }
  std::size_t site_count() const { return count_; }
  bool is_hidden(VertexId v) const { return hidden_.contains(v + 1); }
  std::size_t hidden_count() const { return hidden_.count(); }

  BasicCellView<Site> view() const {
    return BasicCellView<Site>({.cells = cells_.data(),
                                .slots = static_cast<CellId>(cells_.size()),
                                .points = sites_.data(),
                                .scale = scale_});
  }
  std::size_t finite_cell_count() const;
  std::size_t bytes() const {
    return site_bytes() + cells_.bytes() + zone_.bytes() + star_.bytes();
  }

 private:
  static constexpr bool kMayHide = SiteTests<Site>::kMayHide;

  std::size_t site_bytes() const {
    return (count_ + 1) * (sizeof(Site) + 1) + (kMayHide ? count_ / 8 : 0);
  }
  std::size_t most_cells() const;
  bool append(std::span<const Site> added);
  void reserve(std::size_t count);
  bool insert_rounds(std::size_t first, const FirstSimplex& done);
  bool insert_vertex(std::uint32_t vertex, std::size_t most_cells);
  void hide(std::uint32_t vertex, std::uint32_t holder);

  std::size_t max_bytes_;
  GrowableArray<Site> sites_;  // sites_[0] is none: infinity
  std::size_t count_ = 0;
  CoordinateRange range_;
  double scale_ = 1;
  Predicates exact_{CoordinateRange{}};  // for the range and the scale
  CellArray cells_;
  ConflictZone<Site> zone_;
  StarBuilder star_;
  HiddenVertices hidden_;
  std::vector<std::uint32_t> swallowed_;
  std::uint32_t last_cell_ = 0;
  int dimension_ = -1;
  bool is_unusable_ = false;
};

extern template class IncrementalKernel<Point3>;
extern template class IncrementalKernel<WeightedPoint3>;

}  // namespace stream_recon::detail
