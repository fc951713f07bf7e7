#include "io/vtp_codec.h"

#include <libdeflate.h>
#include <lz4.h>

#include <limits>
#include <memory>
#include <new>

namespace stream_recon {

bool decompress_zlib_block(std::span<const char> block, std::span<char> out) {
  const std::unique_ptr<libdeflate_decompressor, decltype(&libdeflate_free_decompressor)> state(
      libdeflate_alloc_decompressor(), libdeflate_free_decompressor);
  if (!state) throw std::bad_alloc();
  // Without a place for the actual size, a block that is shorter than `out` is an error.
  return libdeflate_zlib_decompress(state.get(), block.data(), block.size(), out.data(), out.size(),
                                    nullptr) == LIBDEFLATE_SUCCESS;
}

bool decompress_lz4_block(std::span<const char> block, std::span<char> out) {
  constexpr std::size_t kLongest = std::numeric_limits<int>::max();
  if (block.size() > kLongest || out.size() > kLongest) return false;
  return LZ4_decompress_safe(block.data(), out.data(), static_cast<int>(block.size()),
                             static_cast<int>(out.size())) == static_cast<int>(out.size());
}

}  // namespace stream_recon
