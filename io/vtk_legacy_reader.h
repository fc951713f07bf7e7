// Points of a legacy VTK file (.vtk), ASCII or binary: POLYDATA, UNSTRUCTURED_GRID and
// STRUCTURED_GRID.
//
// Guarantees: all points of the POINTS section; what follows them is not read, beyond making sure
// that it is no further number. An ASCII value is rounded to the declared type. The last number of
// an ASCII file must have a blank or line end behind it, else its digits may be cut.
// Memory: the source's window. Cost: binary about 5 ns a point besides the reading.
#pragma once

#include <memory>

#include "io/byte_source.h"
#include "io/point_source.h"

namespace stream_recon {

/// \throw InputError malformed header, or a dataset without points of its own; IoError
std::unique_ptr<PointSource> make_vtk_legacy_source(std::unique_ptr<ByteSource> source);

}  // namespace stream_recon
