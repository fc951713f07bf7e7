// Arrays as VTK's XML files hold them behind AppendedData: raw, in zlib blocks.
//
// Guarantees: readable by vtkZLibDataCompressor with header_type UInt64, byte order little endian;
// the same bytes for the same data, however it is cut into pieces. The only door to libdeflate's
// compressor.
// Memory: a block of 1 MiB, its compressed form and under 1 MB of tables, whatever the array.
// Thread rule: one thread an object. Format: VTK file formats, "XML file formats"; docs/formats.md.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "io/file.h"

namespace stream_recon {

class VtkXmlBlocks {
 public:
  VtkXmlBlocks();
  ~VtkXmlBlocks();
  VtkXmlBlocks(const VtkXmlBlocks&) = delete;
  VtkXmlBlocks& operator=(const VtkXmlBlocks&) = delete;

  /// Starts an array of `raw_bytes` bytes where `file` stands, which must outlive end().
  /// \throw IoError
  void begin(std::uint64_t raw_bytes, File& file);
  /// The next bytes of the array. \throw IoError
  void put(std::span<const std::byte> raw);
  /// \pre All bytes of the array were put. \throw IoError
  void end();

 private:
  struct Compressor;

  void write_block(std::span<const std::byte> raw);

  std::unique_ptr<Compressor> compressor_;
  std::vector<std::byte> pending_;     ///< less than a block
  std::vector<std::byte> compressed_;  ///< of one block
  File* file_ = nullptr;
  std::uint64_t header_at_ = 0;
  std::uint64_t rest_ = 0;             ///< bytes of the array that were not put yet
  std::vector<std::uint64_t> header_;  ///< sizes of the blocks
};

}  // namespace stream_recon
