// The fixed parts of a block file, as docs/formats.md lays them out: little endian, no padding.
#pragma once

#include <bit>
#include <cstdint>

namespace stream_recon::detail {

static_assert(std::endian::native == std::endian::little, "structs go to disk as they are");

/// At byte 0. Then come the blocks, each behind a BlockHeader, the offsets of all blocks as 64-bit
/// numbers, and the FileTrailer.
struct FileHeader {
  std::uint64_t magic = 0x314b4c4252545321;  // "!STRBLK1"
  std::uint32_t record_bytes = 0;
  std::uint32_t records_per_block = 0;
  std::uint64_t checksum = 0;  ///< of the bytes before
};
static_assert(sizeof(FileHeader) == 24);

struct BlockHeader {
  std::uint32_t magic = 0x4b434c42;  // "BLCK"
  std::uint32_t encoding = 0;        ///< BlockEncoding
  std::uint32_t record_count = 0;
  std::uint32_t raw_bytes = 0;
  std::uint32_t stored_bytes = 0;
  std::uint32_t number = 0;    ///< low 32 bits of the block's number
  std::uint64_t checksum = 0;  ///< of the bytes before and the stored bytes
};
static_assert(sizeof(BlockHeader) == 32);

/// The last bytes of the file.
struct FileTrailer {
  std::uint64_t magic = 0x31444e4552545321;  // "!STREND1"
  std::uint64_t index_offset = 0;
  std::uint64_t block_count = 0;
  std::uint64_t record_count = 0;
  std::uint64_t checksum = 0;  ///< of the index and the bytes before
};
static_assert(sizeof(FileTrailer) == 40);

}  // namespace stream_recon::detail
