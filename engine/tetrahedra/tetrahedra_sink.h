// Where the windows put the tetrahedra: sorted into chunks, on disk.
//
// Guarantees: after finish(), spool() has exactly the tetrahedra of each chunk, that of their
// vertex of lowest rank. Thread rule: add() is thread-safe; the rest belongs to one thread. Memory:
// the buffers of one spool (surface/chunk_spool.h).
#pragma once

#include <mutex>
#include <span>

#include "engine/surface/chunk_layout.h"
#include "engine/surface/chunk_spool.h"
#include "engine/tetrahedra/tetrahedron_record.h"

namespace stream_recon {

class TetrahedraSink {
 public:
  /// \throw IoError, BudgetError
  TetrahedraSink(const ChunkLayout& layout, const SpoolOptions& options)
      : layout_(layout), spool_("tetrahedra", layout.chunk_count(), options) {}

  /// \throw IoError
  void add(std::span<const TetrahedronRecord> tetrahedra);
  /// \throw IoError
  void finish() { spool_.finish(); }

  const ChunkLayout& layout() const { return layout_; }
  const ChunkSpool<TetrahedronRecord>& spool() const { return spool_; }

 private:
  ChunkLayout layout_;
  std::mutex mutex_;
  ChunkSpool<TetrahedronRecord> spool_;
};

}  // namespace stream_recon
