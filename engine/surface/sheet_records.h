// What the search for sheets hands from chunk to chunk (surface/surface_sheets.h).
//
// Ranks take 32 bits here. Layout on disk: docs/formats.md. Thread rule: values. Memory: 16 bytes
// each.
#pragma once

#include <array>
#include <cstdint>
#include <tuple>

#include "engine/windows/final_window.h"

namespace stream_recon {

using ShortRank = std::uint32_t;

/// A triangle as one of its vertices sees it.
struct StarTriangle {
  ShortRank vertex = 0;
  ShortRank low = 0;  ///< the other two, ascending
  ShortRank high = 0;
  /// 1 if vertex, low, high run counterclockwise seen from outside.
  std::uint32_t is_outward = 0;

  ShortRank other_than(ShortRank rank) const { return rank == low ? high : low; }

  /// Of one vertex: in the order of the triangles' sorted ranks, and of two that face each other in
  /// one order.
  friend bool operator<(const StarTriangle& a, const StarTriangle& b) {
    return std::tie(a.vertex, a.low, a.high, a.is_outward) <
           std::tie(b.vertex, b.low, b.high, b.is_outward);
  }
};

/// A wedge at the edge {vertex, other} that shares the sheet of `other` with another wedge of the
/// edge: what `vertex` must know.
struct SheetTouch {
  ShortRank vertex = 0;
  ShortRank other = 0;
  ShortRank third = 0;  ///< of the wedge's triangle that rises from the lower end to the higher
  std::uint32_t sheet = 0;

  friend bool operator<(const SheetTouch& a, const SheetTouch& b) {
    return std::tie(a.vertex, a.other, a.third) < std::tie(b.vertex, b.other, b.third);
  }
};

/// The corner of a triangle at a vertex of several sheets.
struct SheetCorner {
  std::array<ShortRank, 3> ranks{};  ///< of the triangle, ascending
  std::uint32_t place = 0;           ///< 4 * sheet + corner, and kOutward

  /// The triangle is counterclockwise from outside in the order of its ranks: two may have the same
  /// ranks, and face each other.
  static constexpr std::uint32_t kOutward = std::uint32_t{1} << 31;

  bool is_outward() const { return (place & kOutward) != 0; }
  std::uint32_t corner() const { return place % 4; }
  std::uint32_t sheet() const { return (place & ~kOutward) / 4; }
  ShortRank rank() const { return ranks[corner()]; }

  friend bool operator<(const SheetCorner& a, const SheetCorner& b) {
    return std::tie(a.ranks, a.place) < std::tie(b.ranks, b.place);
  }
};

/// Two triangles that are joined across an edge of more than two, where it is not the inside that
/// decides which are.
struct TurnedPair {
  ShortRank low = 0;  ///< ends of the edge, ascending
  ShortRank high = 0;
  /// Third vertices: of the triangle that falls from the high end to the low one, and of the other.
  std::array<ShortRank, 2> thirds{};

  friend bool operator==(const TurnedPair&, const TurnedPair&) = default;
  friend bool operator<(const TurnedPair& a, const TurnedPair& b) {
    return std::tie(a.low, a.high, a.thirds) < std::tie(b.low, b.high, b.thirds);
  }
};

/// A vertex of the split surface as one number: ascending by rank, then by sheet.
using SheetKey = std::uint64_t;

constexpr SheetKey sheet_key(PointRank rank, std::uint32_t sheet) {
  return rank << 32 | sheet;
}

}  // namespace stream_recon
