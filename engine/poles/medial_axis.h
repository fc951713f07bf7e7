// From the pole store to the medial axis in chunks: the balls of one side, or of both.
//
// Guarantees: a ball lies in the chunk of the lowest rank of its samples, in the order of the
// store; so the bytes are a function of the cloud, the sides and the chunk layout alone. Chunks
// without balls are not written. Thread rule: one caller; works on all threads that the memory
// allows. Memory: 16 bytes a chunk; a chunk a thread: 93 bytes a ball and 4 MB.
#pragma once

#include "engine/chunks/chunk_layout.h"
#include "engine/stage_context.h"
#include "io/medial_axis_writer.h"

namespace stream_recon {

struct MedialAxisOptions {
  ChunkLayout layout;
  bool takes_inner = true;
  bool takes_outer = false;
};

/// \throw IoError, BudgetError, Interrupted
void write_medial_axis(const MedialAxisOptions& options, MedialAxisWriter& writer,
                       const StageContext& context);

}  // namespace stream_recon
