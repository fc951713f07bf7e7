// Coordinates as output files hold them: float32 where that loses nothing, else float64.
//
// Thread rule: pure functions.
#pragma once

#include <cstddef>

#include "spatial/point.h"

namespace stream_recon {

class ByteSink;

enum class Scalar { kFloat32, kFloat64 };

std::size_t scalar_bytes(Scalar scalar);

/// Puts x, y, z; kFloat32 demands coordinates that are float32 values.
void put_point(ByteSink& sink, const Point3& point, Scalar scalar);

}  // namespace stream_recon
