#include "io/ply_reader.h"

#include "io/ply_body.h"
#include "io/ply_header.h"

namespace stream_recon {

std::unique_ptr<PointSource> make_ply_source(std::unique_ptr<ByteSource> source) {
  PlyHeader header = read_ply_header(*source);
  return header.format == PlyFormat::kAscii ? make_ply_ascii_body(std::move(source), header)
                                            : make_ply_binary_body(std::move(source), header);
}

}  // namespace stream_recon
