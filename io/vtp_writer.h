// One chunk of a surface as a VTK XML PolyData file (.vtp): appended, raw, compressed.
//
// Guarantees: the bytes are a function of the chunk and the scalar type alone. Memory: one block
// of an array. Thread rule: one thread. Layout: docs/formats.md.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "io/file.h"
#include "io/surface_writer.h"
#include "io/vtk_xml_blocks.h"

namespace stream_recon {

class VtpWriter {
 public:
  VtpWriter(Scalar coordinates, bool has_sheets) : scalar_(coordinates), has_sheets_(has_sheets) {}

  /// Writes the chunk to `file`, new and empty. \throw IoError
  void write(const SurfaceChunk& chunk, File& file);

 private:
  std::optional<std::span<const std::uint32_t>> sheets_of(const SurfaceChunk& chunk) const;

  Scalar scalar_;
  bool has_sheets_;
  VtkXmlBlocks blocks_;
};

}  // namespace stream_recon
