// The cells in conflict with a point: those whose circumsphere holds it.
//
// Guarantees: find() marks exactly the cells in conflict dead and lists them and their boundary;
// nothing else changes. The zone is star-shaped seen from the point (exact predicates, ties
// perturbed), so that cells from its boundary to the point fill it (Bowyer 1981, Watson 1981).
// Memory: the largest zone seen. Thread rule: one writer. Cost: four in-sphere tests at a time;
// about 50 tests a point of a random cloud.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "spatial/cell_array.h"
#include "spatial/point.h"
#include "spatial/predicates.h"
#include "spatial/sphere_batch.h"
#include "spatial/work_list.h"

namespace stream_recon::detail {

/// A facet between two cells, as a link to it from either side.
struct SharedFacet {
  std::uint32_t inner;  ///< as a facet of the cell in the zone
  std::uint32_t outer;  ///< as a facet of the cell beyond
};

/// Whether p is inside the circumsphere of a cell or, for an infinite one, beyond its hull facet.
/// In the plane of the facet the circumsphere shrinks to the facet's circumcircle.
bool is_in_conflict(const Cell& cell, const Point3* points, const Point3& p,
                    const Predicates& predicates);

class ConflictZone {
 public:
  ConflictZone() : test_spheres_(select_sphere_batch_test()) {}

  struct Request {
    const Point3* points;      ///< by vertex
    std::uint32_t vertex;      ///< the point
    std::uint32_t first_cell;  ///< a cell in conflict with it
  };
  void find(CellArray& cells, const Predicates& predicates, const Request& request);

  const WorkList<std::uint32_t>& cells() const { return zone_; }
  const WorkList<SharedFacet>& boundary() const { return boundary_; }
  std::size_t bytes() const { return zone_.bytes() + pending_.bytes() + boundary_.bytes(); }

 private:
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

  SphereBatchTest test_spheres_;
  WorkList<std::uint32_t> zone_;
  WorkList<SharedFacet> pending_;  // facets of the zone to cross
  std::size_t next_ = 0;           // the first of them not crossed yet
  WorkList<SharedFacet> boundary_;
};

}  // namespace stream_recon::detail
