// The components of the whole surface, from the pieces of its chunks.
//
// Guarantees: counts and sums are functions of the surface and the chunk layout, whatever the
// order in which chunks come. Thread rule: add() from one thread at a time; finish() once, after
// them. Memory, from the budget: 64 bytes a chunk and kWritingMemory while chunks come; 8 bytes,
// of a solid 32, for each piece that reaches other chunks; about 5 MB more while they are joined,
// where there are any. Cost: what is told of shared edges goes to disk and is sorted there.
// Source: union-find, Tarjan 1975.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/chunks/chunk_layout.h"
#include "engine/scratch_records.h"
#include "engine/stage_context.h"
#include "engine/surface/chunk_pieces.h"
#include "engine/surface/piece_forest.h"

namespace stream_recon {

/// What a chunk adds to the whole.
struct ChunkSums {
  DoubleDouble area;
  DoubleDouble six_volumes;  ///< of a solid
};

struct JoinedPieces {
  std::uint64_t components = 0;  ///< all that are no cavities
  std::uint64_t cavities = 0;    ///< closed, with a negative volume; of solids only
  DoubleDouble area;
  DoubleDouble six_volumes;
};

class PieceJoin {
 public:
  struct Options {
    ChunkLayout layout;
    bool is_solid = false;
  };

  /// \throw BudgetError, IoError
  PieceJoin(const Options& options, const StageContext& context);
  ~PieceJoin();
  PieceJoin(const PieceJoin&) = delete;
  PieceJoin& operator=(const PieceJoin&) = delete;

  /// \throw IoError, BudgetError
  void add(std::uint64_t chunk, const ChunkPieces& pieces, const ChunkSums& sums);
  /// \throw IoError, BudgetError, Interrupted
  JoinedPieces finish();

  static constexpr std::uint64_t kWritingMemory = record_file_memory(std::uint64_t{32} << 10);

 private:
  /// What must be known of the pieces of a chunk that reach others.
  struct Chunk {
    ChunkSums sums;
    std::uint64_t reaching = 0;  ///< how many; in the end how many there are before the chunk's
    std::vector<PieceFacts> facts;
  };

  void judge(const PieceFacts& piece);
  void collect_facts();
  void join_at_shared_edges();
  void join_uses(std::span<const SharedEdge> edge);
  void join_wedges(std::span<const SharedEdge> uses, std::span<const SharedEdge> wedges);
  std::uint64_t piece_of(const SharedEdge& use) const;

  const Options options_;
  const StageContext& context_;
  Reservation memory_;
  std::vector<Chunk> chunks_;
  std::optional<RecordWriter<SharedEdge>> writer_;
  std::uint64_t reaching_ = 0;
  std::vector<PieceFacts> facts_;  ///< of all pieces that reach others
  std::optional<PieceForest<std::uint64_t>> forest_;
  JoinedPieces joined_;
};

}  // namespace stream_recon
