// The sheets of the surface at one vertex: the fans that its triangles form when bodies that touch
// along an edge or in a point are taken apart.
//
// Around an edge of more than two triangles those two are joined that bound one inside wedge; at a
// vertex, triangles joined across edges are one sheet. Where that leaves two wedges of an edge in
// one sheet at both of its ends, the copies of the edge would have the same ends. There part()
// joins triangles that bound one outside wedge instead, which separates their sheets at both ends:
// it is decided by what both ends found before, and no other wedges get into one sheet by it
// (docs/algorithms/sheets.md).
// Guarantees: with the touches of the far ends taken into account, the triangles of each sheet of a
// vertex of a closed surface form one closed fan, and no two wedges of an edge have the same sheets
// at both ends. Sheets are numbered by their lowest triangles in the order of the ranks.
// Thread rule: a value. Memory: about 100 bytes a triangle. Cost: 100 ns a triangle.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/surface/ranked_points.h"
#include "engine/surface/sheet_records.h"

namespace stream_recon {

/// Whether the triangles form one closed fan. For large stars false means: perhaps not.
bool is_closed_fan(std::span<const StarTriangle> star);

class VertexSheets {
 public:
  /// \param star all triangles of one vertex, ascending; must outlive this
  /// \param points has all of the star \throw std::logic_error the surface is not closed here
  VertexSheets(std::span<const StarTriangle> star, const RankedPoints& points);

  std::uint32_t count() const { return count_; }
  /// Of each triangle.
  const std::vector<std::uint32_t>& sheets() const { return sheets_; }

  /// What the far ends of edges must know, for part(). If there are none, all is known.
  std::vector<SheetTouch> touches() const;
  /// \param from_far_ends of this vertex, sorted
  void part(std::span<const SheetTouch> from_far_ends);

  /// How triangles are joined at the edges where part() changed it.
  std::vector<TurnedPair> turned_pairs() const;

  /// Edges to vertices of higher rank that have more than two triangles.
  std::uint64_t multiple_edges() const;
  /// Copies of those beyond the first.
  std::uint64_t added_edges() const;

 private:
  /// Two triangles that are joined across an edge: in an inside wedge of an edge of more than two,
  /// where inside is counterclockwise of the first seen from the far end.
  using Wedge = std::array<std::uint32_t, 2>;
  /// An edge with more than two triangles, and the wedges there, counterclockwise.
  struct MultipleEdge {
    ShortRank other = 0;
    std::vector<Wedge> wedges;
    bool is_turned = false;
  };
  struct Spoke {
    ShortRank other = 0;
    std::uint32_t triangle = 0;
  };

  void find_wedges(std::span<const Spoke> spokes, const RankedPoints& points);
  void part(MultipleEdge& edge, std::span<const SheetTouch> from_far_ends) const;
  void number_sheets();
  ShortRank third_of(const Wedge& wedge, ShortRank other) const;

  std::span<const StarTriangle> star_;
  std::vector<Wedge> plain_;  ///< of edges with two triangles
  std::vector<MultipleEdge> multiple_;
  std::vector<std::uint32_t> sheets_;
  std::uint32_t count_ = 0;
};

}  // namespace stream_recon
