// Points of a PLY file: the vertex element, in any of the three PLY formats.
//
// Guarantees: elements before the vertices are stepped over, those behind are neither read nor
// required to be complete: points are whole where the vertices are. Where vertices come last,
// anything but white space behind them is refused, since the header then miscounts them. An ascii
// value is rounded to the type its property declares, so an ascii and a binary copy give the same
// points; in ascii an element is a line, and the last one must have its line end: without it
// nobody can tell whether its last digits are missing.
// Memory: the source's window. Cost: binary about 5 ns a point besides the reading.
#pragma once

#include <memory>

#include "io/byte_source.h"
#include "io/point_source.h"

namespace stream_recon {

/// \throw InputError malformed header; IoError
std::unique_ptr<PointSource> make_ply_source(std::unique_ptr<ByteSource> source);

}  // namespace stream_recon
