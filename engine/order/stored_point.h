// A point as it lies on disk between ingest and windows.
//
// Thread rule: a value. Memory: 32 bytes.
#pragma once

#include <cstdint>
#include <type_traits>

#include "spatial/point.h"

namespace stream_recon {

struct StoredPoint {
  Point3 point;
  std::uint64_t input_index = 0;  ///< position among all points of all inputs, from 0
};

static_assert(sizeof(StoredPoint) == 32 && std::is_trivially_copyable_v<StoredPoint>);

}  // namespace stream_recon
