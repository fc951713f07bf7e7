// Points of a VTK XML file (.vtp, and .vtu alike): ASCII, base64 or appended; plain, zlib or LZ4.
//
// Guarantees: the points of all pieces, in the order of the file where they stand in the XML, in
// the order of their offsets where they are appended. Numbers in ASCII are rounded to the array's
// type. An appended section is not read beyond the last points; all other files must be complete.
// Memory: that of VtpArrayReader and a fixed buffer. Cost: that of the decompression.
#pragma once

#include <memory>

#include "io/byte_source.h"
#include "io/point_source.h"

namespace stream_recon {

/// \throw InputError no VTK XML file with points; IoError
std::unique_ptr<PointSource> make_vtp_source(std::unique_ptr<ByteSource> source);

}  // namespace stream_recon
