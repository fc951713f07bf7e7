// The compressors of VTK XML files. The one door to zlib's format when reading, and to LZ4.
#pragma once

#include <cstddef>
#include <span>

namespace stream_recon {

/// Fill the whole of `out` from one compressed block; false where it holds anything else than
/// exactly that many bytes. Stateless.
bool decompress_zlib_block(std::span<const char> block, std::span<char> out);
bool decompress_lz4_block(std::span<const char> block, std::span<char> out);

}  // namespace stream_recon
