// From the pole store to the medial axis in chunks: the balls of one side, or of both, and the
// faces of the power shape between them.
//
// Guarantees: a ball lies in the chunk of the lowest rank of its samples, in the order of the
// store, and a face in the chunk of its first ball; balls of later chunks that it touches follow
// those of the chunk. So the bytes are a function of the cloud, the options and the chunk layout
// alone. Chunks without balls are not written. Thread rule: one caller; works on all threads that
// the memory allows. Memory: 16 bytes a chunk, with faces 48; a chunk a thread: 93 bytes a ball and
// 4 MB; with faces 8 more a ball, 12 a face, and 117 a ball of later chunks.
#pragma once

#include "engine/chunks/chunk_layout.h"
#include "engine/stage_context.h"
#include "io/medial_axis_writer.h"

namespace stream_recon {

struct MedialAxisOptions {
  ChunkLayout layout;
  bool takes_inner = true;
  bool takes_outer = false;
  bool has_faces =
      false;  ///< the power shape is in the scratch directory, and inner balls are taken
};

/// \throw IoError, BudgetError, Interrupted
void write_medial_axis(const MedialAxisOptions& options, MedialAxisWriter& writer,
                       const StageContext& context);

}  // namespace stream_recon
