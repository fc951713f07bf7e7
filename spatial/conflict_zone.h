// The cells in conflict with a site: those whose circumsphere holds it or, with weights, whose
// orthogonal sphere it is closer than orthogonal to.
//
// Guarantees: find() marks exactly the cells in conflict dead and lists them and their boundary;
// nothing else changes. The zone is star-shaped seen from the site (exact predicates, ties
// perturbed), so that cells from its boundary to the site fill it (Bowyer 1981, Watson 1981).
// Memory: the largest zone seen. Thread rule: one writer. Cost: four in-sphere tests at a time;
// about 50 tests a point of a random cloud.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "spatial/cell_array.h"
#include "spatial/predicates.h"
#include "spatial/site_tests.h"
#include "spatial/work_list.h"

namespace stream_recon::detail {

/// A facet between two cells, as a link to it from either side.
struct SharedFacet {
  std::uint32_t inner;  ///< as a facet of the cell in the zone
  std::uint32_t outer;  ///< as a facet of the cell beyond
};

struct ZoneLists {
  WorkList<std::uint32_t> cells;
  WorkList<SharedFacet> boundary;
};

/// Whether a site is in conflict with a cell or, for an infinite one, beyond its hull facet. In the
/// plane of the facet the sphere shrinks to the facet's circle.
template <class Site>
bool is_in_conflict(const Cell& cell, const Site* sites, const Site& query,
                    const Predicates& predicates);

/// \tparam Site Point3 or WeightedPoint3
template <class Site>
class ConflictZone {
 public:
  struct Request {
    const Site* sites;         ///< by vertex
    std::uint32_t vertex;      ///< the site
    std::uint32_t first_cell;  ///< a cell in conflict with it
  };
  void find(CellArray& cells, const Predicates& predicates, const Request& request);

  const ZoneLists& lists() const { return lists_; }
  std::size_t bytes() const {
    return lists_.cells.bytes() + lists_.boundary.bytes() + pending_.bytes();
  }

 private:
  using Tests = SiteTests<Site>;
  struct Batch {
    std::array<SharedFacet, 5> facet;  // one more is written than counts
    unsigned count = 0;
    unsigned in_conflict = 0;  // a bit a facet
  };
  Batch next_batch(const CellArray& cells);
  void test(Batch& batch, const CellArray& cells, const Predicates& predicates,
            const Request& request) const;
  void sort_out(const Batch& batch, CellArray& cells);
  void add(CellArray& cells, std::uint32_t cell, std::uint32_t entered_by, bool counts);

  typename Tests::BatchTest test_four_ = Tests::select_batch_test();
  ZoneLists lists_;
  WorkList<SharedFacet> pending_;  // facets of the zone to cross
  std::size_t next_ = 0;           // the first of them not crossed yet
};

extern template class ConflictZone<Point3>;
extern template class ConflictZone<WeightedPoint3>;

}  // namespace stream_recon::detail
