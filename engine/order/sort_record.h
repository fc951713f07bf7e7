// A point with the key it is sorted by.
//
// Thread rule: a value. Memory: 40 bytes.
#pragma once

#include <cstdint>
#include <type_traits>

#include "engine/order/stored_point.h"

namespace stream_recon {

struct SortRecord {
  std::uint64_t key = 0;
  StoredPoint stored;

  /// Total: no two points of an input share their index.
  friend bool operator<(const SortRecord& a, const SortRecord& b) {
    if (a.key != b.key) return a.key < b.key;
    if (a.stored.point < b.stored.point) return true;
    if (b.stored.point < a.stored.point) return false;
    return a.stored.input_index < b.stored.input_index;
  }
};

static_assert(sizeof(SortRecord) == 40 && std::is_trivially_copyable_v<SortRecord>);

}  // namespace stream_recon
