// One chunk of a surface as a VTK XML PolyData file (.vtp): appended, raw, compressed.
//
// Guarantees: the bytes are a function of the chunk and the scalar type alone. Memory: one block
// of an array. Thread rule: one thread. Layout: docs/formats.md.
#pragma once

#include "io/file.h"
#include "io/surface_writer.h"
#include "io/vtk_xml_blocks.h"

namespace stream_recon {

class VtpWriter {
 public:
  /// \param has_closure whether the chunk has one to be written
  VtpWriter(Scalar coordinates, bool has_closure)
      : scalar_(coordinates), has_closure_(has_closure) {}

  /// Writes the chunk to `file`, new and empty. \throw IoError
  void write(const SurfaceChunk& chunk, File& file);

 private:
  Scalar scalar_;
  bool has_closure_;
  VtkXmlBlocks blocks_;
};

}  // namespace stream_recon
