// A surface as a .pvtp index and a folder of .vtp chunks beside it; docs/formats.md.
//
// Guarantees: chunks are written in a folder of another name; at finish() everything is forced to
// the device, an older result steps aside index first, the folder takes its name, then the index:
// a readable index means a complete result, never a mixed one. When a step fails, the older result
// steps back. A folder of that name with files that are no chunks is refused at the start.
#pragma once

#include <memory>

#include "io/surface_writer.h"

namespace stream_recon {

/// \throw IoError cannot create; std::invalid_argument the name is nothing but its ending
std::unique_ptr<SurfaceWriter> make_pvtp_writer(const SurfaceWriterOptions& options);

}  // namespace stream_recon
