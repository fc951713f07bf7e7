// Numbers to bytes of a stated order.
//
// Thread rule: plain values. Memory: the bytes put.
#pragma once

#include <bit>
#include <cstddef>
#include <cstring>
#include <iterator>
#include <span>
#include <vector>

namespace stream_recon {

class ByteSink {
 public:
  ByteSink(std::endian order, std::size_t capacity) : swaps_(order != std::endian::native) {
    bytes_.reserve(capacity);
  }

  /// Appends a number, least significant byte first in little endian order.
  template <class Number>
  void put(Number value) {
    std::byte bytes[sizeof value];  // NOLINT(modernize-avoid-c-arrays): its size is the type's
    std::memcpy(bytes, &value, sizeof value);
    if (swaps_) {
      bytes_.insert(bytes_.end(), std::reverse_iterator(bytes + sizeof value),
                    std::reverse_iterator(bytes + 0));
    } else {
      bytes_.insert(bytes_.end(), bytes, bytes + sizeof value);
    }
  }

  std::span<const std::byte> bytes() const { return bytes_; }

 private:
  std::vector<std::byte> bytes_;
  bool swaps_;
};

}  // namespace stream_recon
