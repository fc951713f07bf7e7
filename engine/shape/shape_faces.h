// The part of the power shape that a window of the power diagram emits.
//
// The power shape has the simplices of the regular triangulation whose poles are all inside the
// body: it is homotopy equivalent to the union of the inner cells. Guarantees: of all windows
// together each simplex is counted once, and each triangle, and each edge without one, is emitted
// once, by the window that owns the pole of lowest number: stars of owned poles are final. Thread
// rule: one thread. Memory: about what shape_faces_memory() says. Cost: about 6 us an owned pole.
// Source: Amenta, Choi, Kolluri, The power crust, 2001, section 3; docs/algorithms/crust.md
#pragma once

#include <cstdint>
#include <vector>

#include "engine/power/power_window.h"
#include "engine/shape/shape_records.h"

namespace stream_recon {

struct ShapeCounts {
  std::uint64_t vertices = 0;  ///< inner poles that have a cell
  std::uint64_t edges = 0;
  std::uint64_t bare_edges = 0;  ///< of these: without a triangle
  std::uint64_t triangles = 0;
  std::uint64_t tetrahedra = 0;

  void add(const ShapeCounts& other);
};

struct ShapeFaces {
  std::vector<ShapeFace> faces;  ///< ascending
  ShapeCounts counts;
};

/// \pre build() of the window returned kDone
ShapeFaces shape_faces(const PowerWindow& power);

/// What shape_faces() may be expected to need beside the window, bytes.
std::uint64_t shape_faces_memory(const PowerWindow& power);

}  // namespace stream_recon
