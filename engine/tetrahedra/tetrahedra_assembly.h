// From tetrahedra in chunks to their output: one pass over the chunks, several at once.
//
// Guarantees: the chunks handed to the writer are functions of the tetrahedra and the chunk layout,
// not of the order in which the tetrahedra came, the memory or the threads: tetrahedra ascend by
// their sorted ranks, points by rank. Chunks without tetrahedra are not written.
// Thread rule: one caller; works on all threads that the memory allows. Memory: a chunk a thread:
// 16 bytes a tetrahedron, 40 to 56 a point and 4 MB each.
#pragma once

#include "engine/stage_context.h"
#include "engine/tetrahedra/exported_tetrahedra.h"
#include "io/tetrahedra_writer.h"

namespace stream_recon {

/// \throw IoError, BudgetError, Interrupted
void assemble_tetrahedra(const ExportedTetrahedra& tetrahedra, TetrahedraWriter& writer,
                         const StageContext& context);

}  // namespace stream_recon
