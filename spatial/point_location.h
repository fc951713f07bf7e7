// Finds a cell that holds a point: a visibility walk through the Delaunay structure or
// the regular one of weighted points.
//
// Guarantees: ends, because the walk is acyclic in a regular triangulation (its ties decided by a
// perturbation of the lifts) with exact orientations. Cost: linear in the cells crossed; about 7
// from the last inserted point to the next on a Hilbert curve.
// Thread rule: const.
// Source: Devillers, Pion, Teillaud 2002 ("Walking in a triangulation").
#pragma once

#include <cstdint>

#include "spatial/cell_array.h"
#include "spatial/point.h"
#include "spatial/predicates.h"

namespace stream_recon::detail {

template <class Site>
struct LocationRequest {
  const Site* sites;         ///< by vertex
  std::uint32_t start_cell;  ///< any live cell, best a near one
  Point3 query;
};

/// A finite cell that contains the query, borders included, or an infinite cell whose hull facet
/// sees it. \tparam Site Point3 or WeightedPoint3; weights do not matter here
template <class Site>
std::uint32_t locate(const CellArray& cells, const Predicates& predicates,
                     const LocationRequest<Site>& request);

}  // namespace stream_recon::detail
