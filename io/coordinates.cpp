#include "io/coordinates.h"

#include <cassert>

#include "io/byte_sink.h"

namespace stream_recon {

std::size_t scalar_bytes(Scalar scalar) {
  return scalar == Scalar::kFloat32 ? sizeof(float) : sizeof(double);
}

void put_point(ByteSink& sink, const Point3& point, Scalar scalar) {
  for (const double value : {point.x, point.y, point.z}) {
    if (scalar == Scalar::kFloat32) {
      assert(static_cast<double>(static_cast<float>(value)) == value);
      sink.put(static_cast<float>(value));
    } else {
      sink.put(value);
    }
  }
}

}  // namespace stream_recon
