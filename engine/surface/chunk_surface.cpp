#include "engine/surface/chunk_surface.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "engine/surface/edge_census.h"
#include "engine/surface/orientation.h"
#include "engine/surface/sheet_split.h"
#include "engine/surface/solid_chunk.h"
#include "spatial/triangle_measure.h"

namespace stream_recon {
namespace {

constexpr const char* kHolder =
    "assembling a chunk of the surface (a smaller --chunk-points needs less)";

/// A point store's cursor; a block of an array, its compressed form and the compressor's tables.
constexpr std::uint64_t kFixedBytes = std::uint64_t{3} << 20;
/// A triangle's corners and the rest of a facet, with its record and its place in the order, or
/// with three edges and its place in a component and among the pieces.
constexpr std::uint64_t kWorkingTriangle = 68;
/// Of a solid the same with its corners once more, each with a place among those of its vertex.
constexpr std::uint64_t kSolidTriangle = 92;
/// A vertex' rank, and its bucket of edges; of a solid its rank and its place once more.
constexpr std::uint64_t kWorkingVertex = 12;
constexpr std::uint64_t kSolidVertex = 24;
/// A facet's record, corners, edges and their places.
constexpr std::uint64_t kBorderFacet = 32 + 12 + 36 + 12 + 24;
/// What is told of an edge, and the use it is made of.
constexpr std::uint64_t kToldEdge = sizeof(SharedEdge) + sizeof(EdgeUse);

/// How many of `ranks`, ascending and distinct, are not among `sorted`.
std::uint64_t count_others(std::span<const PointRank> ranks, std::span<const PointRank> sorted) {
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
  result.closure = std::move(facets.closure);
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

/// Of coordinates times `scale`.
DoubleDouble area_of(const SurfaceChunk& chunk, double scale) {
  double area = 0;
  double lost = 0;  // by rounding; apart, so that a sum need not wait for the one before
  for (const auto& v : chunk.triangles) {
    const double term =
        triangle_area(scaled(chunk.points[v[0]], scale), scaled(chunk.points[v[1]], scale),
                      scaled(chunk.points[v[2]], scale));
    const DoubleDouble sum = exact_sum(area, term);
    area = sum.high;
    lost += sum.low;
  }
  return exact_sum(area, lost);
}

/// To each piece what its triangles add to its volume, of coordinates times `scale`; the sum.
DoubleDouble add_volumes(const SurfaceChunk& chunk, double scale, ChunkPieces& pieces) {
  for (std::size_t t = 0; t < chunk.triangles.size(); ++t) {
    const auto& v = chunk.triangles[t];
    DoubleDouble& volume = pieces.facts[pieces.of_triangle[t]].volume;
    volume = volume + six_cone_volumes(scaled(chunk.points[v[0]], scale),
                                       scaled(chunk.points[v[1]], scale),
                                       scaled(chunk.points[v[2]], scale));
  }
  DoubleDouble sum;
  for (const PieceFacts& piece : pieces.facts) sum = sum + piece.volume;
  return sum;
}

/// Those of the chunk itself among its vertices, which ascend.
std::span<const PointRank> own_part(std::span<const PointRank> vertices, PointRank end) {
  const auto own_end = std::lower_bound(vertices.begin(), vertices.end(), end);
  return vertices.first(static_cast<std::size_t>(own_end - vertices.begin()));
}

}  // namespace

std::uint64_t ChunkSurfaceMaker::working_memory(std::uint64_t triangles,
                                                std::uint64_t vertices) const {
  return options_.is_solid ? triangles * kSolidTriangle + vertices * kSolidVertex
                           : triangles * kWorkingTriangle + vertices * kWorkingVertex;
}

/// The chunk, and what a writer adds: blocks, or all of it in another form.
std::uint64_t ChunkSurfaceMaker::output_memory(std::uint64_t triangles,
                                               std::uint64_t vertices) const {
  // The closure, what the writer makes of it, and the number of the piece.
  const std::uint64_t of_solid = options_.is_solid ? triangles * 12 : 0;
  const std::uint64_t of_sheets = sheets_ != nullptr ? vertices * sizeof(std::uint32_t) : 0;
  return of_solid + of_sheets +
         (numbering_ != nullptr ? triangles * 38 + vertices * 84 : triangles * 18 + vertices * 40);
}

std::uint64_t ChunkSurfaceMaker::typical_memory(std::uint64_t triangles) const {
  const std::uint64_t vertices = triangles / 2;
  return kFixedBytes + ExportReader::read_memory() +
         std::max(working_memory(triangles, vertices), output_memory(triangles, vertices));
}

ChunkSurface ChunkSurfaceMaker::make(std::uint64_t chunk) const {
  context_.stop.check();
  ChunkSurface result;
  const std::uint64_t triangles = surface_.facets().count(chunk);
  const auto needed = [&](std::uint64_t vertices) {
    return kFixedBytes +
           std::max(working_memory(triangles, vertices), output_memory(triangles, vertices));
  };
  result.memory = context_.budget.reserve(needed(0), kHolder);
  ChunkFacets facets = read_facets(chunk);
  result.memory.resize(needed(facets.vertices.size()));
  result.counts.triangles = triangles;
  const std::vector<bool> reversed = options_.is_solid ? examine_solid(chunk, facets, result)
                                                       : examine_open(chunk, facets, result);
  SplitFacets split;
  if (sheets_ != nullptr) split = split_facets(*sheets_, chunk, context_.budget, facets);
  result.memory.resize(kFixedBytes + output_memory(triangles, facets.vertices.size()) +
                       result.pieces.told.size() * sizeof(SharedEdge) +
                       result.pieces.facts.size() * sizeof(PieceFacts));
  take_triangles(facets, reversed, result.chunk);
  read_points(store_, facets.vertices, result.chunk.points, result.chunk.global_ids);
  if (numbering_ != nullptr) {
    result.chunk.vertex_numbers =
        numbering_->numbers_of(chunk, sheets_ != nullptr ? split.keys : facets.vertices);
  }
  result.chunk.sheets = std::move(split.sheets);
  measure(result);
  if (options_.unused != nullptr) find_unused(chunk, facets.vertices, result);
  return result;
}

ChunkFacets ChunkSurfaceMaker::read_facets(std::uint64_t chunk) const {
  const ChunkLayout& layout = surface_.layout();
  ChunkVertices points(layout.first_rank(chunk), layout.end_rank(chunk), context_.budget);
  return ChunkFacets(surface_.facets().records(chunk), points);
}

/// Of the chunk's points those that facets of earlier chunks use, ascending, each once. The caller
/// reserves as much as there are border points.
std::vector<PointRank> ChunkSurfaceMaker::border_ranks(std::uint64_t chunk) const {
  std::vector<PointRank> ranks;
  ranks.reserve(surface_.border_points().count(chunk));
  surface_.border_points().visit(chunk, [&ranks](std::span<const BorderPoint> part) {
    for (const BorderPoint& use : part) ranks.push_back(use.rank);
  });
  std::sort(ranks.begin(), ranks.end());
  ranks.erase(std::unique(ranks.begin(), ranks.end()), ranks.end());
  return ranks;
}

std::vector<bool> ChunkSurfaceMaker::examine_open(std::uint64_t chunk, const ChunkFacets& facets,
                                                  ChunkSurface& result) const {
  const PointRank end = surface_.layout().end_rank(chunk);
  {
    const Reservation memory =
        context_.budget.reserve(surface_.border_points().count(chunk) * sizeof(PointRank), kHolder);
    const auto own = own_part(facets.vertices, end);
    result.counts.vertices = own.size() + count_others(border_ranks(chunk), own);
  }
  const auto uses = sorted_edge_uses(facets.triangles);
  Orientation orientation = orient(uses, facets.facing);
  const Reservation memory = context_.budget.reserve(
      surface_.border_edges().count(chunk) * (sizeof(BorderEdge) + kToldEdge), kHolder);
  auto handed_over = surface_.border_edges().records(chunk);
  std::sort(handed_over.begin(), handed_over.end());
  const EdgeCensus::ChunkEdges edges{
      .uses = uses, .ranks = facets.vertices, .handed_over = handed_over, .end = end};
  EdgeCensus census;
  census.add(edges);
  result.counts.edges = census.edges();
  result.counts.boundary_edges = census.boundary();
  result.counts.nonmanifold_edges = census.nonmanifold();
  result.pieces = pieces_at_edges(std::move(orientation.component), facets, edges);
  return std::move(orientation.reversed);
}

std::vector<bool> ChunkSurfaceMaker::examine_solid(std::uint64_t chunk, const ChunkFacets& facets,
                                                   ChunkSurface& result) const {
  const Reservation memory = context_.budget.reserve(
      surface_.border_facets().count(chunk) * (kBorderFacet + 3 * kToldEdge) +
          (sheets_ != nullptr ? sheets_->turned_count(chunk) * sizeof(TurnedPair) : 0),
      kHolder);
  std::vector<TurnedPair> turned;
  if (sheets_ != nullptr) turned = sheets_->turned_pairs(chunk);
  const std::vector<FacetRecord> border = surface_.border_facets().records(chunk);
  SolidChunk solid = examine_solid_chunk({.own = facets,
                                          .border = border,
                                          .first = surface_.layout().first_rank(chunk),
                                          .end = surface_.layout().end_rank(chunk),
                                          .turned = turned},
                                         {store_, options_.range, context_.budget});
  result.counts.vertices = solid.counts.vertices;
  result.counts.edges = solid.counts.edges;
  result.counts.boundary_edges = solid.counts.boundary_edges;
  result.counts.nonmanifold_edges = solid.counts.nonmanifold_edges;
  result.counts.unpaired_uses = solid.counts.unpaired_uses;
  result.counts.fans = solid.counts.fans;
  result.pieces = std::move(solid.pieces);
  return turned_outward(facets.facing);
}

void ChunkSurfaceMaker::measure(ChunkSurface& result) const {
  const SurfaceChunk& chunk = result.chunk;
  result.counts.digest = digest_of(chunk);
  result.counts.add_deltas(chunk.delta);
  result.counts.add_closures(chunk.closure, chunk.source);
  result.sums.area = area_of(chunk, scale_);
  if (options_.is_solid) {
    result.sums.six_volumes = add_volumes(chunk, scale_, result.pieces);
  } else {
    result.chunk.closure.clear();
  }
  result.pieces.of_triangle = {};
}

void ChunkSurfaceMaker::find_unused(std::uint64_t chunk, std::span<const PointRank> vertices,
                                    ChunkSurface& result) const {
  const ChunkLayout& layout = surface_.layout();
  constexpr std::uint64_t kPoint = sizeof(Point3) + 2 * sizeof(std::uint64_t);
  const std::uint64_t points = layout.points_in(chunk);
  const std::uint64_t border = surface_.border_points().count(chunk) * sizeof(PointRank);
  const std::uint64_t before = result.memory.bytes();
  result.memory.resize(before + border + points * kPoint);
  std::vector<PointRank> unused(points);
  std::iota(unused.begin(), unused.end(), layout.first_rank(chunk));
  const auto leave_out = [&unused](std::span<const PointRank> used) {
    auto next = used.begin();
    std::erase_if(unused, [&](PointRank rank) {
      while (next != used.end() && *next < rank) ++next;
      return next != used.end() && *next == rank;
    });
  };
  leave_out(own_part(vertices, layout.end_rank(chunk)));
  leave_out(border_ranks(chunk));
  std::vector<std::uint64_t> input_indices;
  read_points(store_, unused, result.unused, input_indices);
  // The points, and how a writer encodes them.
  result.memory.resize(before + result.unused.size() * 2 * sizeof(Point3));
}

}  // namespace stream_recon
