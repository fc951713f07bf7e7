// Points of a framed point stream (io/pts_layout.h).
//
// Guarantees: a point is delivered only after the checksum of its frame was found right; a stream
// that was cut anywhere, even between two frames, that was changed anywhere, or that goes on behind
// its end frame is refused. Memory: one frame, at most 1.5 MiB. Thread rule: one reader.
#pragma once

#include <memory>

#include "io/byte_source.h"
#include "io/point_source.h"

namespace stream_recon {

/// \throw InputError malformed header; IoError
std::unique_ptr<PointSource> make_pts_source(std::unique_ptr<ByteSource> source);

}  // namespace stream_recon
