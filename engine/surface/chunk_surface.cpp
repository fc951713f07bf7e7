#include "engine/surface/chunk_surface.h"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "engine/surface/edge_census.h"
#include "engine/surface/orientation.h"
#include "engine/surface/sheet_split.h"

namespace stream_recon {
namespace {

constexpr const char* kHolder =
    "assembling a chunk of the surface (a smaller --chunk-points needs less)";

/// A point store's cursor; a block of an array, its compressed form and the compressor's tables.
constexpr std::uint64_t kFixedBytes = std::uint64_t{3} << 20;
/// A triangle's corners and the rest of a facet, with its record and its place in the order, or
/// with three edges and its place in a component.
constexpr std::uint64_t kWorkingTriangle = 64;
/// A vertex' rank, and its bucket of edges.
constexpr std::uint64_t kWorkingVertex = 12;

/// The chunk, and what a writer adds: blocks, or all of it in another form.
std::uint64_t output_memory(std::uint64_t triangles, std::uint64_t vertices, bool is_numbered) {
  return is_numbered ? triangles * 38 + vertices * 84 : triangles * 18 + vertices * 40;
}

std::uint64_t needed_memory(std::uint64_t triangles, std::uint64_t vertices, bool is_numbered) {
  return kFixedBytes + std::max(triangles * kWorkingTriangle + vertices * kWorkingVertex,
                                output_memory(triangles, vertices, is_numbered));
}

/// How many of `ranks` are not among `sorted`.
std::uint64_t count_others(std::vector<PointRank> ranks, std::span<const PointRank> sorted) {
  std::sort(ranks.begin(), ranks.end());
  ranks.erase(std::unique(ranks.begin(), ranks.end()), ranks.end());
  std::uint64_t others = 0;
  auto next = sorted.begin();
  for (const PointRank rank : ranks) {
    next = std::lower_bound(next, sorted.end(), rank);
    if (next == sorted.end() || *next != rank) ++others;
  }
  return others;
}

/// Moves the facets into the chunk, each turned the way it shall face.
void take_triangles(ChunkFacets& facets, const std::vector<bool>& reversed, SurfaceChunk& result) {
  result.triangles = std::move(facets.triangles);
  result.delta = std::move(facets.delta);
  result.source = std::move(facets.source);
  for (std::size_t t = 0; t < result.triangles.size(); ++t) {
    if (reversed[t]) std::swap(result.triangles[t][1], result.triangles[t][2]);
  }
}

SimplexDigest digest_of(const SurfaceChunk& chunk) {
  SimplexDigest digest;
  for (const auto& v : chunk.triangles) {
    digest.add<3>({chunk.global_ids[v[0]], chunk.global_ids[v[1]], chunk.global_ids[v[2]]});
  }
  return digest;
}

}  // namespace

std::uint64_t ChunkSurfaceMaker::typical_memory(std::uint64_t triangles) {
  return needed_memory(triangles, triangles / 2, false) + ExportReader::read_memory();
}

ChunkSurface ChunkSurfaceMaker::make(std::uint64_t chunk) const {
  context_.stop.check();
  ChunkSurface result;
  const std::uint64_t triangles = surface_.facets().count(chunk);
  const bool is_numbered = numbering_ != nullptr;
  result.memory = context_.budget.reserve(needed_memory(triangles, 0, is_numbered), kHolder);
  ChunkFacets facets = read_facets(chunk);
  result.memory.resize(needed_memory(triangles, facets.vertices.size(), is_numbered));
  result.counts.triangles = triangles;
  result.counts.vertices = count_vertices(chunk, facets);
  std::vector<bool> reversed;
  {
    const auto uses = sorted_edge_uses(facets.triangles);
    count_edges(chunk, facets, uses, result.counts);
    reversed = sheets_ != nullptr ? turned_outward(facets.facing) : reversals(uses, facets.facing);
  }
  SplitFacets split;
  if (sheets_ != nullptr) split = split_facets(*sheets_, chunk, context_.budget, facets);
  result.memory.resize(kFixedBytes + output_memory(triangles, facets.vertices.size(), is_numbered));
  take_triangles(facets, reversed, result.chunk);
  read_points(store_, facets.vertices, result.chunk.points, result.chunk.global_ids);
  if (is_numbered) {
    result.chunk.vertex_numbers =
        numbering_->numbers_of(chunk, sheets_ != nullptr ? split.keys : facets.vertices);
  }
  result.chunk.sheets = std::move(split.sheets);
  result.counts.digest = digest_of(result.chunk);
  result.counts.add_deltas(result.chunk.delta);
  return result;
}

ChunkFacets ChunkSurfaceMaker::read_facets(std::uint64_t chunk) const {
  const ChunkLayout& layout = surface_.layout();
  ChunkVertices points(layout.first_rank(chunk), layout.end_rank(chunk), context_.budget);
  return ChunkFacets(surface_.facets().records(chunk), points);
}

std::uint64_t ChunkSurfaceMaker::count_vertices(std::uint64_t chunk,
                                                const ChunkFacets& facets) const {
  const auto end = std::lower_bound(facets.vertices.begin(), facets.vertices.end(),
                                    surface_.layout().end_rank(chunk));
  const std::span own(facets.vertices.begin(), end);
  const Reservation memory = context_.budget.reserve(
      surface_.border_points().count(chunk) * (sizeof(BorderPoint) + sizeof(PointRank)), kHolder);
  std::vector<PointRank> border;
  {
    const auto uses = surface_.border_points().records(chunk);
    border.reserve(uses.size());
    for (const BorderPoint& use : uses) border.push_back(use.rank);
  }
  return own.size() + count_others(std::move(border), own);
}

void ChunkSurfaceMaker::count_edges(std::uint64_t chunk, const ChunkFacets& facets,
                                    std::span<const EdgeUse> uses, SurfaceCounts& counts) const {
  const Reservation memory =
      context_.budget.reserve(surface_.border_edges().count(chunk) * sizeof(BorderEdge), kHolder);
  auto handed_over = surface_.border_edges().records(chunk);
  std::sort(handed_over.begin(), handed_over.end());
  EdgeCensus census;
  census.add({.uses = uses,
              .ranks = facets.vertices,
              .handed_over = handed_over,
              .end = surface_.layout().end_rank(chunk)});
  counts.edges = census.edges();
  counts.boundary_edges = census.boundary();
  counts.nonmanifold_edges = census.nonmanifold();
}

}  // namespace stream_recon
