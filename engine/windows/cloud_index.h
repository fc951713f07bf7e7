// The index over the Hilbert-ordered store: where in space the points of a stretch of ranks lie.
//
// Guarantees: the bounds of every node hold all its points, conservatively (spatial/node_bounds.h).
// Built in one streaming pass; pages lie in the scratch directory, the top stays in memory.
// Thread rule: const and shared once built. Memory: 60 bytes for 1000 points; on disk 8 bytes a
// point, 6 when compressed. Source: packed Hilbert R-tree (Kamel, Faloutsos 1994).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/order/ingest.h"
#include "engine/stage_context.h"
#include "engine/windows/index_layout.h"
#include "engine/windows/sphere_shells.h"
#include "spatial/box.h"
#include "spatial/coordinate_range.h"
#include "spatial/node_bounds.h"

namespace stream_recon {

/// Name of the pages (records of NodeBounds, one page a block) in the scratch directory.
inline constexpr const char* kIndexPages = "index";

struct CloudIndex {
  std::uint64_t point_count = 0;
  CoordinateRange range;
  /// A power of two that brings the coordinates to where squares of lengths are doubles; 1 for all
  /// but extreme clouds. Everything below and the search are in scaled coordinates.
  double scale = 1;
  Box3 box;          ///< of the points, exactly
  Point3 origin;     ///< of all node bounds
  double reach = 0;  ///< no coordinate, nor one relative to origin, is larger
  /// top[0] are the roots of the pages; four nodes of a level make one of the next; the last has
  /// one.
  std::vector<std::vector<NodeBounds>> top;
  SphereShells shells;
  /// Ranks of four affinely independent points, no far ones; any window that has them has
  /// tetrahedra.
  std::array<PointRank, 4> simplex{};
  Reservation memory;

  std::uint64_t leaf_count() const {
    return index_layout::quotient_up(point_count, index_layout::kLeafPoints);
  }
};

/// \throw InputError the points have no tetrahedra, far points aside: too few, or all in one plane;
///        or their coordinates are too far apart in magnitude
/// \throw IoError, BudgetError, Interrupted
CloudIndex build_index(const CloudSummary& cloud, std::uint64_t point_count,
                       const StageContext& context);

}  // namespace stream_recon
