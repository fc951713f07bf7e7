// The bodies of PLY files, behind make_ply_source (io/ply_reader.h), whose contract they keep.
#pragma once

#include <memory>

#include "io/byte_source.h"
#include "io/ply_header.h"
#include "io/point_source.h"

namespace stream_recon {

/// `source` stands at the first byte of the body; so for both.
std::unique_ptr<PointSource> make_ply_ascii_body(std::unique_ptr<ByteSource> source,
                                                 const PlyHeader& header);
std::unique_ptr<PointSource> make_ply_binary_body(std::unique_ptr<ByteSource> source,
                                                  const PlyHeader& header);

}  // namespace stream_recon
