// The faces of the power shape by chunks of the medial axis: each lies in that of its first pole.
//
// Guarantees: visit() gives a chunk's faces, ascending. Thread rule: const for many threads.
// Memory, from the budget: 24 bytes a chunk, and record_cursor_memory(kShapeBlock) a call of
// visit(). Cost: one pass over the store to make it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/budget.h"
#include "engine/shape/shape_store.h"
#include "engine/stage_context.h"

namespace stream_recon {

class ShapeChunks {
 public:
  /// \param pole_ends for each chunk, ascending: what its poles' numbers are below
  /// \throw IoError, BudgetError, Interrupted
  ShapeChunks(std::span<const std::uint64_t> pole_ends, const StageContext& context);

  /// Faces of a chunk.
  std::uint64_t count(std::uint64_t chunk) const {
    return chunks_[chunk + 1].first - chunks_[chunk].first;
  }
  std::uint64_t edges(std::uint64_t chunk) const { return chunks_[chunk].edges; }
  /// How often its faces have a corner in a later chunk.
  std::uint64_t later_corners(std::uint64_t chunk) const { return chunks_[chunk].later_corners; }

  /// Calls visit(face) for the faces of a chunk. \throw IoError, BudgetError
  template <class Visit>
  void visit(std::uint64_t chunk, const Visit& visit) const {
    const Reservation memory = budget_.reserve(reading_memory(), "reading the power shape");
    RecordCursor<ShapeFace> cursor(file_);
    cursor.seek(chunks_[chunk].first);
    std::vector<ShapeFace> batch(kBatch);
    for (std::uint64_t rest = count(chunk); rest > 0; rest -= batch.size()) {
      batch.resize(std::min<std::uint64_t>(rest, kBatch));
      cursor.read(batch);
      for (const ShapeFace& face : batch) visit(face);
    }
  }

  static constexpr std::uint64_t reading_memory() {
    return record_cursor_memory(kShapeBlock) + kBatch * sizeof(ShapeFace);
  }

 private:
  static constexpr std::size_t kBatch = 1 << 12;

  struct Chunk {
    std::uint64_t first = 0;  ///< of its faces
    std::uint64_t edges = 0;
    std::uint64_t later_corners = 0;
  };

  MemoryBudget& budget_;
  Reservation memory_;
  ShapeFile file_;
  std::vector<Chunk> chunks_;  ///< and one more, behind all faces
};

}  // namespace stream_recon
