// Compresses and restores one block of records; the only door to zstd.
//
// Guarantees: decode() restores what encode() got bit for bit. A block that does not shrink is
// stored as it is. Decoding damaged bytes never leaves the buffers, but may go unnoticed: check a
// checksum first, as io/block_file.h does.
// Thread rule: one codec per thread; contexts and buffers are reused. Memory: memory_bytes(), about
// 2 blocks + 0.7 MB. Source: zstd (RFC 8878) on the planes of io/byte_planes.h; figures in
// docs/formats.md.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace stream_recon {

/// How the bytes of a block came about; the values stand in files.
enum class BlockEncoding : std::uint32_t { kStored = 0, kZstd = 1, kZstdPlanes = 2 };

struct EncodedBlock {
  BlockEncoding encoding = BlockEncoding::kStored;
  /// Of the codec's buffer or of the raw bytes: valid until either changes.
  std::span<const std::byte> bytes;
};

class BlockCodec {
 public:
  BlockCodec();
  ~BlockCodec();
  BlockCodec(BlockCodec&&) noexcept;
  BlockCodec& operator=(BlockCodec&&) noexcept;

  /// Encodes whole records, at most 1 GiB.
  EncodedBlock encode(std::span<const std::byte> raw, std::size_t record_bytes);

  /// Restores what encode() got to `raw`, whose size must be the raw size.
  /// Returns whether the bytes were an encoded block of that size.
  bool decode(BlockEncoding encoding, std::span<const std::byte> stored, std::size_t record_bytes,
              std::span<std::byte> raw);

  /// What the codec holds now.
  std::size_t memory_bytes() const;

 private:
  struct Contexts;

  bool decompress(std::span<const std::byte> stored, std::span<std::byte> raw);

  std::unique_ptr<Contexts> contexts_;
  std::vector<std::byte> planes_;
  std::vector<std::byte> compressed_;
};

}  // namespace stream_recon
