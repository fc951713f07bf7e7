// Counts the edges of the whole surface chunk by chunk.
//
// Guarantees: each edge is counted once, in the chunk of its vertex of lowest rank, with the uses
// of all chunks: a triangle of an earlier chunk hands over the edge that belongs here. Thread rule:
// one thread. Memory: a few words.
#pragma once

#include <cstdint>
#include <span>
#include <tuple>

#include "engine/surface/edge_uses.h"
#include "engine/windows/final_window.h"

namespace stream_recon {

/// An edge of a chunk that a triangle of an earlier chunk uses.
struct BorderEdge {
  PointRank low = 0;
  PointRank high = 0;

  friend bool operator==(const BorderEdge&, const BorderEdge&) = default;
  friend bool operator<(const BorderEdge& a, const BorderEdge& b) {
    return std::tie(a.low, a.high) < std::tie(b.low, b.high);
  }
};

class EdgeCensus {
 public:
  /// What one chunk knows of its edges.
  struct ChunkEdges {
    std::span<const EdgeUse> uses;            ///< of the chunk's triangles, sorted
    std::span<const PointRank> ranks;         ///< of the chunk's vertices, ascending
    std::span<const BorderEdge> handed_over;  ///< by earlier chunks, sorted
    PointRank end = 0;  ///< edges with their low vertex from here on are not its
  };

  void add(const ChunkEdges& chunk);

  std::uint64_t edges() const { return edges_; }
  std::uint64_t boundary() const { return boundary_; }
  std::uint64_t nonmanifold() const { return nonmanifold_; }

 private:
  void count(std::uint64_t uses);

  std::uint64_t edges_ = 0;
  std::uint64_t boundary_ = 0;
  std::uint64_t nonmanifold_ = 0;
};

}  // namespace stream_recon
