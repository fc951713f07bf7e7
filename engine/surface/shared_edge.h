// What a chunk tells of the edges that triangles of other chunks use too.
//
// Guarantees: sorted, all that is told of an edge stands together, its uses first, in an order that
// depends on the surface and the chunk layout only. Thread rule: a value. Memory: 32 bytes.
#pragma once

#include <cstdint>
#include <tuple>
#include <type_traits>

#include "engine/windows/final_window.h"

namespace stream_recon {

/// Either that a triangle has the edge, or that two triangles bound one wedge of the inside there.
struct SharedEdge {
  PointRank low = 0;
  PointRank high = 0;
  PointRank apex = 0;  ///< the triangle's third corner
  /// Of a use: the number of the triangle's piece in its chunk, and whether the triangle rises
  /// (edge_wedges.h). Of a wedge: the other triangle's apex.
  std::uint64_t value = 0;

  static SharedEdge use(const SharedEdge& at, std::uint32_t piece, bool rises) {
    return {at.low, at.high, at.apex, 2 * std::uint64_t{piece} + (rises ? 1 : 0)};
  }
  static SharedEdge wedge(const SharedEdge& at, PointRank other_apex) {
    return {at.low, at.high, at.apex, kWedge | other_apex};
  }

  bool is_wedge() const { return (value & kWedge) != 0; }
  PointRank other_apex() const { return value & ~kWedge; }
  std::uint32_t piece() const { return static_cast<std::uint32_t>(value / 2); }
  bool rises() const { return value % 2 != 0; }
  /// The lowest corner, whose chunk has the triangle.
  PointRank lowest_corner() const { return apex < low ? apex : low; }

  bool has_edge_of(const SharedEdge& other) const { return low == other.low && high == other.high; }
  friend bool operator<(const SharedEdge& a, const SharedEdge& b) {
    return std::tuple(a.low, a.high, a.is_wedge(), a.apex, a.value) <
           std::tuple(b.low, b.high, b.is_wedge(), b.apex, b.value);
  }

 private:
  static constexpr std::uint64_t kWedge = std::uint64_t{1} << 63;
};

static_assert(sizeof(SharedEdge) == 32 && std::is_trivially_copyable_v<SharedEdge>);

}  // namespace stream_recon
