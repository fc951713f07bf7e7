// Arrays as VTK's XML files hold them behind AppendedData: raw, in zlib blocks.
//
// Guarantees: readable by vtkZLibDataCompressor with header_type UInt64, byte order little endian;
// the same bytes for the same data. The only door to libdeflate's compressor.
// Memory: one compressed block and under 1 MB of tables. Thread rule: one thread an object.
// Format: VTK file formats, "XML file formats"; docs/formats.md.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace stream_recon {

class VtkXmlBlocks {
 public:
  VtkXmlBlocks();
  ~VtkXmlBlocks();
  VtkXmlBlocks(const VtkXmlBlocks&) = delete;
  VtkXmlBlocks& operator=(const VtkXmlBlocks&) = delete;

  /// Appends the encoded form of `raw` to `out`.
  void append(std::span<const std::byte> raw, std::vector<std::byte>& out);

 private:
  struct Compressor;

  std::unique_ptr<Compressor> compressor_;
  std::vector<std::byte> block_;
};

}  // namespace stream_recon
