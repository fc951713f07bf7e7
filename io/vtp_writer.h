// One chunk of a surface as a VTK XML PolyData file (.vtp): appended, raw, compressed.
//
// Guarantees: the bytes are a function of the chunk and the scalar type alone. Memory: the encoded
// chunk and its largest array. Thread rule: one thread. Layout: docs/formats.md.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "io/file.h"
#include "io/surface_writer.h"
#include "io/vtk_xml_blocks.h"

namespace stream_recon {

/// The attributes of <VTKFile> that all our XML files share, and the name of the scalar type.
extern const char* const kVtkXmlAttributes;
const char* vtk_type(Scalar scalar);

class VtpWriter {
 public:
  explicit VtpWriter(Scalar coordinates) : scalar_(coordinates) {}

  /// Writes the chunk to `file`, new and empty. \throw IoError
  void write(const SurfaceChunk& chunk, File& file);

 private:
  std::string data_array(const std::string& attributes, std::span<const std::byte> raw);
  std::string point_arrays(const SurfaceChunk& chunk);
  std::string cell_arrays(const SurfaceChunk& chunk);

  Scalar scalar_;
  VtkXmlBlocks blocks_;
  std::vector<std::byte> appended_;
};

}  // namespace stream_recon
