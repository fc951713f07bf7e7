// The poles of the whole cloud on disk, each ball once, by the lowest rank of its samples: in
// Hilbert order.
//
// Guarantees: ascending by tetrahedron, each with a finite ball and its label; a function of the
// cloud alone. Read while the scratch directory lasts; damage is noticed. Thread rule: PoleFile
// const access from many; a reader belongs to one thread. Memory, from the budget:
// PoleReader::memory() a reader. Layout: docs/formats.md.
#pragma once

#include <cstdint>
#include <span>

#include "engine/budget.h"
#include "engine/poles/pole.h"
#include "engine/scratch_records.h"

namespace stream_recon {

/// Name of the store (records of Pole) in the scratch directory.
inline constexpr const char* kPoleStore = "poles";

inline constexpr std::size_t kPoleStoreBlock = std::size_t{128} << 10;

/// The store itself, for several threads.
using PoleFile = RecordFile<Pole>;

class PoleReader {
 public:
  /// \pre `file` outlives the reader. \throw BudgetError
  PoleReader(const PoleFile& file, MemoryBudget& budget)
      : memory_(budget.reserve(memory(), "reading poles")), cursor_(file) {}

  static constexpr std::uint64_t memory() { return record_cursor_memory(kPoleStoreBlock); }

  /// The next read begins at this pole.
  void seek(std::uint64_t pole) { cursor_.seek(pole); }
  /// Fills the front of `out` with the next poles; their number, less than asked only at the end.
  /// \throw IoError
  std::size_t read(std::span<Pole> out) { return cursor_.read(out); }

 private:
  Reservation memory_;
  RecordCursor<Pole> cursor_;
};

}  // namespace stream_recon
