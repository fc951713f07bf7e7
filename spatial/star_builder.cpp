#include "spatial/star_builder.h"

#include <array>
#include <bit>
#include <cassert>

namespace stream_recon::detail {

// The new cell takes the place of the zone's cell at the facet; the vertex stands where the vertex
// opposite the facet stood, which keeps the orientation and infinity in the last place.
inline std::uint32_t StarBuilder::build_cell(CellArray& cells, const SharedFacet& facet,
                                             std::uint32_t vertex) {
  const std::uint32_t i = facet_of(facet.inner);
  const std::uint32_t built = cells.allocate();
  const Cell& old = cells[cell_of(facet.inner)];
  Cell& cell = cells[built];
  for (int k = 0; k < 4; ++k) cell.vertex[k] = old.vertex[k];
  cell.vertex[0] &= ~kDead;
  cell.vertex[i] = vertex;
  cell.link[i] = facet.outer;
  cells[cell_of(facet.outer)].link[facet_of(facet.outer)] = facet_link(built, i);
  return facet_link(built, i);
}

std::uint32_t StarBuilder::build(CellArray& cells, const ZoneLists& zone, std::uint32_t vertex) {
  built_.resize(zone.boundary.size());
  std::uint32_t* built = built_.data();
  for (const SharedFacet& facet : zone.boundary) *built++ = build_cell(cells, facet, vertex);
  if (built_.size() <= kSmallFacets) {
    link_few(cells);
  } else {
    link_many(cells);
  }
  cells.release(zone.cells.begin(), zone.cells.size());
  return cell_of(built_.back());
}

void StarBuilder::link_few(CellArray& cells) {
  std::array<std::uint32_t, kSmall + 1> labelled;  // one more is written, then not counted
  std::uint8_t* const labels = labels_.data();
  std::uint32_t* const table = small_table_.data();
  std::uint16_t* reversed = reversed_.data();
  std::uint32_t count = 0;
  for (const std::uint32_t facet : built_) {
    const Cell& cell = cells[cell_of(facet)];
    const std::uint8_t* corner = kFacet[facet_of(facet)];
    std::uint32_t label[3];
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t vertex = cell.vertex[corner[i]];
      // Without a branch: whether a vertex was seen before is as good as random.
      const std::uint32_t known = labels[vertex];
      labelled[count] = vertex;
      count += known == 0 ? 1 : 0;
      label[i] = known == 0 ? count : known;
      labels[vertex] = static_cast<std::uint8_t>(label[i]);
      --label[i];
    }
    // Facet corner[i] of the cell holds the inserted point and the edge from the next corner to
    // the one after.
    const std::uint32_t cell_bits = facet & ~std::uint32_t{3};
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t from = label[(i + 1) % 3];
      const std::uint32_t to = label[(i + 2) % 3];
      table[from * kSmall + to] = cell_bits | corner[i];
      *reversed++ = static_cast<std::uint16_t>(to * kSmall + from);
    }
  }
  reversed = reversed_.data();
  for (const std::uint32_t facet : built_) {
    Cell& cell = cells[cell_of(facet)];
    const std::uint8_t* corner = kFacet[facet_of(facet)];
    for (int i = 0; i < 3; ++i) cell.link[corner[i]] = table[*reversed++];
  }
  for (std::uint32_t i = 0; i < count; ++i) labels[labelled[i]] = 0;
}

StarBuilder::DirectedEdge& StarBuilder::slot(std::uint64_t ends) {
  const std::size_t mask = large_table_.size() - 1;
  std::size_t at = (ends * 0x9e3779b97f4a7c15u >> 20) & mask;
  while (large_table_[at].ends != 0 && large_table_[at].ends != ends) at = (at + 1) & mask;
  return large_table_[at];
}

void StarBuilder::link_many(CellArray& cells) {
  const auto ends = [](std::uint32_t from, std::uint32_t to) {
    return std::uint64_t{from} << 32 | to;
  };
  large_table_.assign(std::bit_ceil(6 * built_.size()), {0, 0});
  for (const std::uint32_t facet : built_) {
    const Cell& cell = cells[cell_of(facet)];
    const std::uint8_t* corner = kFacet[facet_of(facet)];
    for (int i = 0; i < 3; ++i) {
      const std::uint64_t edge =
          ends(cell.vertex[corner[(i + 1) % 3]], cell.vertex[corner[(i + 2) % 3]]);
      slot(edge) = {edge, (facet & ~std::uint32_t{3}) | corner[i]};
    }
  }
  for (const std::uint32_t facet : built_) {
    Cell& cell = cells[cell_of(facet)];
    const std::uint8_t* corner = kFacet[facet_of(facet)];
    for (int i = 0; i < 3; ++i) {
      const DirectedEdge& twin =
          slot(ends(cell.vertex[corner[(i + 2) % 3]], cell.vertex[corner[(i + 1) % 3]]));
      assert(twin.ends != 0);
      cell.link[corner[i]] = twin.facet;
    }
  }
}

// A vertex of the zone lives on if it is a corner of the boundary, and so of a cell built there.
void StarBuilder::find_swallowed(const CellArray& cells, const ZoneLists& zone,
                                 std::vector<std::uint32_t>& swallowed) {
  std::uint8_t* const labels = labels_.data();
  const auto label_boundary = [&](std::uint8_t label) {
    for (const std::uint32_t facet : built_) {
      const Cell& cell = cells[cell_of(facet)];
      for (const std::uint8_t corner : kFacet[facet_of(facet)]) labels[cell.vertex[corner]] = label;
    }
  };
  label_boundary(1);
  const std::size_t known = swallowed.size();
  for (const std::uint32_t dead : zone.cells) {
    for (int i = 0; i < 4; ++i) {
      const std::uint32_t vertex = vertex_of(cells[dead], i);
      if (labels[vertex] != 0) continue;
      labels[vertex] = 1;
      swallowed.push_back(vertex);
    }
  }
  label_boundary(0);
  for (std::size_t i = known; i < swallowed.size(); ++i) labels[swallowed[i]] = 0;
}

std::size_t StarBuilder::bytes() const {
  return built_.capacity() * sizeof(std::uint32_t) + small_table_.size() * sizeof(std::uint32_t) +
         reversed_.size() * sizeof(std::uint16_t) + large_table_.capacity() * sizeof(DirectedEdge);
}

}  // namespace stream_recon::detail
