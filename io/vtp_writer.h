// One chunk of a surface as a VTK XML PolyData file (.vtp): appended, raw, compressed.
//
// Guarantees: the bytes are a function of the chunk and the options alone. Memory: one block
// of an array. Thread rule: one thread. Layout: docs/formats.md.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "io/file.h"
#include "io/surface_writer.h"
#include "io/vtk_xml_blocks.h"

namespace stream_recon {

struct VtpWriterOptions {
  Scalar coordinates = Scalar::kFloat64;
  bool has_closure = false;  ///< chunks have one to be written
  bool has_sheets = false;   ///< the same
};

class VtpWriter {
 public:
  explicit VtpWriter(const VtpWriterOptions& options) : options_(options) {}

  /// Writes the chunk to `file`, new and empty. \throw IoError
  void write(const SurfaceChunk& chunk, File& file);

 private:
  std::optional<std::span<const std::uint32_t>> sheets_of(const SurfaceChunk& chunk) const;

  VtpWriterOptions options_;
  VtkXmlBlocks blocks_;
};

}  // namespace stream_recon
