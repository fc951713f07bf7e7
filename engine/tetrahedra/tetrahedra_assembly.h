// From tetrahedra in chunks to their output: one ascending pass over the chunks.
//
// Guarantees: the chunks handed to the writer are functions of the tetrahedra and the chunk layout,
// not of the order in which the tetrahedra came: tetrahedra ascend by their sorted ranks, points by
// rank. Chunks without tetrahedra are not written.
// Thread rule: one caller; sorts on all threads. Memory: one chunk, 16 bytes a tetrahedron and 32
// to 48 a point.
#pragma once

#include "engine/stage_context.h"
#include "engine/tetrahedra/exported_tetrahedra.h"
#include "io/tetrahedra_writer.h"

namespace stream_recon {

/// \throw IoError, BudgetError, Interrupted
void assemble_tetrahedra(const ExportedTetrahedra& tetrahedra, TetrahedraWriter& writer,
                         const StageContext& context);

}  // namespace stream_recon
