// Points as bare little-endian numbers, x y z x y z ..., float32 or float64, without a header.
//
// Guarantees: an input whose size is no whole number of points is refused; a file at once, a pipe
// where it ends. Memory: the source's window. Cost: about 3 ns a point besides the reading.
#pragma once

#include <memory>

#include "io/byte_source.h"
#include "io/point_source.h"
#include "io/scalar_type.h"

namespace stream_recon {

/// `type` is kFloat32 or kFloat64. \throw InputError a file of the wrong size
std::unique_ptr<PointSource> make_raw_source(std::unique_ptr<ByteSource> source, ScalarType type);

}  // namespace stream_recon
