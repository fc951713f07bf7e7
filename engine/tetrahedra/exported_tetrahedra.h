// The tetrahedra that all windows have exported, by chunk: that of their vertex of lowest rank.
//
// Thread rule: const access from many. Memory: the reader's.
#pragma once

#include "engine/chunks/chunk_layout.h"
#include "engine/tetrahedra/tetrahedron_record.h"
#include "engine/windows/export_reader.h"

namespace stream_recon {

/// \pre The reader outlives it.
struct ExportedTetrahedra {
  ExportedTetrahedra(const ExportReader& reader, const ChunkLayout& chunk_layout)
      : layout(chunk_layout), records(reader, ExportKind::kTetrahedra) {}

  ChunkLayout layout;
  ExportedRecords<TetrahedronRecord> records;
};

}  // namespace stream_recon
