// The part of a legacy VTK file before its points.
//
// Guarantees: behind it the source stands at the first byte of the point values. Field data and
// metadata before the points are stepped over, in ASCII and in binary files.
// Memory: none beyond the source's window.
// Source: "VTK File Formats" (Kitware), simple legacy formats, versions 1 to 5.
#pragma once

#include <cstdint>

#include "io/scalar_type.h"
#include "io/text_reader.h"

namespace stream_recon {

struct VtkLegacyHeader {
  bool binary = false;
  std::uint64_t points = 0;
  ScalarType type = ScalarType::kFloat32;  ///< of the coordinates
};

/// `text` reads from `source`, both at the start of the file.
/// \throw InputError malformed, or a dataset without explicit points
VtkLegacyHeader read_vtk_legacy_header(ByteSource& source, TextReader& text);

}  // namespace stream_recon
