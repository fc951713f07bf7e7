#include "engine/surface/sheet_split.h"

#include <algorithm>
#include <array>

namespace stream_recon {
namespace {

constexpr const char* kHolder =
    "splitting a chunk of the surface into sheets (a smaller --chunk-points needs less)";

/// Where each corner's sheet is among the vertices; both ascend by triangle.
void turn_to_sheets(std::span<const SheetCorner> corners, std::span<const SheetKey> keys,
                    ChunkFacets& facets) {
  const std::span<const PointRank> ranks = facets.vertices;
  // Of each rank, its first vertex.
  std::vector<std::uint32_t> first(ranks.size());
  std::uint32_t next = 0;
  for (std::size_t i = 0; i < ranks.size(); ++i) {
    first[i] = next;
    while (next < keys.size() && keys[next] >> 32 == ranks[i]) ++next;
  }
  auto corner = corners.begin();
  for (std::size_t t = 0; t < facets.triangles.size(); ++t) {
    LocalTriangle& triangle = facets.triangles[t];
    const bool is_outward = facets.facing[t] == Facing::kOutward;
    const auto is_of_triangle = [&](const SheetCorner& c, const std::array<ShortRank, 3>& named) {
      return c.ranks == named && c.is_outward() == is_outward;
    };
    LocalTriangle split{};
    std::array<ShortRank, 3> named{};
    for (int i = 0; i < 3; ++i) {
      split[i] = first[triangle[i]];
      named[i] = static_cast<ShortRank>(ranks[triangle[i]]);
    }
    for (; corner != corners.end() && is_of_triangle(*corner, named); ++corner) {
      const SheetKey key = sheet_key(corner->rank(), corner->sheet());
      std::uint32_t& vertex = split[corner->corner()];
      while (keys[vertex] != key) ++vertex;
    }
    triangle = split;
  }
}

}  // namespace

std::vector<SheetKey> split_vertices(std::span<const PointRank> ranks,
                                     std::span<const SheetCorner> corners) {
  std::vector<SheetKey> split;
  split.reserve(corners.size());
  for (const SheetCorner& corner : corners) {
    split.push_back(sheet_key(corner.rank(), corner.sheet()));
  }
  std::sort(split.begin(), split.end());
  split.erase(std::unique(split.begin(), split.end()), split.end());
  std::vector<SheetKey> keys;
  keys.reserve(ranks.size() + split.size());
  auto next = split.begin();
  for (const PointRank rank : ranks) {
    if (next == split.end() || *next >> 32 != rank) keys.push_back(sheet_key(rank, 0));
    for (; next != split.end() && *next >> 32 == rank; ++next) keys.push_back(*next);
  }
  return keys;
}

SplitFacets split_facets(const SurfaceSheets& sheets, std::uint64_t chunk, MemoryBudget& budget,
                         ChunkFacets& facets) {
  const std::uint64_t corner_count = sheets.corner_count(chunk);
  SplitFacets split;
  // Corners, keys twice, and per vertex its key and the first of its rank.
  split.memory =
      budget.reserve(corner_count * (sizeof(SheetCorner) + 2 * sizeof(SheetKey)) +
                         facets.vertices.size() * (2 * sizeof(SheetKey) + sizeof(std::uint32_t)),
                     kHolder);
  {
    const auto corners = sheets.corners(chunk);
    split.keys = split_vertices(facets.vertices, corners);
    if (!corners.empty()) turn_to_sheets(corners, split.keys, facets);
  }
  facets.vertices.clear();
  for (const SheetKey key : split.keys) {
    facets.vertices.push_back(key >> 32);
    split.sheets.push_back(static_cast<std::uint32_t>(key));
  }
  split.memory.resize(split.keys.size() * (sizeof(SheetKey) + sizeof(std::uint32_t)));
  return split;
}

}  // namespace stream_recon
