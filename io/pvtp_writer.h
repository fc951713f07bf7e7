// A surface as a .pvtp index and a folder of .vtp chunks beside it; docs/formats.md.
//
// Guarantees, and how an older result is replaced: io/chunked_output.h.
#pragma once

#include <memory>

#include "io/surface_writer.h"

namespace stream_recon {

/// \throw IoError cannot create; std::invalid_argument the name is nothing but its ending
std::unique_ptr<SurfaceWriter> make_pvtp_writer(const SurfaceWriterOptions& options);

}  // namespace stream_recon
