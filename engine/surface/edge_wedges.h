// Which triangles around an edge bound the same part of the solid.
//
// Guarantees: exact, so a function of points and ranks alone, whoever asks, from either end.
// Triangles that do not bound any solid, because others are missing, may be left without a partner.
// Thread rule: pure functions. Cost: n log n orientation tests for n triangles.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/windows/final_window.h"
#include "spatial/predicates.h"

namespace stream_recon {

/// A triangle at an edge from a low to a high vertex.
struct WedgeSide {
  Point3 apex;
  PointRank rank = 0;  ///< of the apex
  /// Whether it runs along the edge from low to high when seen from outside, counterclockwise.
  bool rises = false;
  std::uint32_t name = 0;
};

/// The names of the two sides of each wedge of the inside, around the edge from `low` to `high`:
/// the one that falls first. Where triangles overlap or have no area, as rounded corners of a crust
/// may make them, so that their turn tells nothing, each side that rises goes with some side that
/// falls. \param sides of all triangles at the edge \pre The points are in the range of the
/// predicates.
std::vector<std::array<std::uint32_t, 2>> inside_wedges(const std::array<Point3, 2>& edge,
                                                        std::span<WedgeSide> sides,
                                                        const Predicates& predicates);

}  // namespace stream_recon
