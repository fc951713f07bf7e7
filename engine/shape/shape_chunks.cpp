#include "engine/shape/shape_chunks.h"

namespace stream_recon {

ShapeChunks::ShapeChunks(std::span<const std::uint64_t> pole_ends, const StageContext& context)
    : budget_(context.budget),
      memory_(budget_.reserve((pole_ends.size() + 1) * sizeof(Chunk) + reading_memory(),
                              "the chunks of the power shape")),
      file_(context.scratch.open(kShapeStore)),
      chunks_(pole_ends.size() + 1) {
  RecordCursor<ShapeFace> cursor(file_);
  std::vector<ShapeFace> batch(kBatch);
  std::size_t chunk = 0;
  std::uint64_t at = 0;
  while (const std::size_t count = cursor.read(batch)) {
    context.stop.check();
    for (std::size_t i = 0; i < count; ++i, ++at) {
      const ShapeFace& face = batch[i];
      while (face.poles[0] >= pole_ends[chunk]) chunks_[++chunk].first = at;
      chunks_[chunk].edges += face.is_edge() ? 1 : 0;
      for (const PoleNumber pole : face.poles) {
        chunks_[chunk].later_corners += pole != kNoPole && pole >= pole_ends[chunk] ? 1 : 0;
      }
    }
  }
  while (chunk < pole_ends.size()) chunks_[++chunk].first = at;
  memory_.resize(chunks_.size() * sizeof(Chunk));
}

}  // namespace stream_recon
