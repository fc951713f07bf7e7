#include "engine/surface/surface_sheets.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "engine/chunks/chunk_loop.h"
#include "io/error.h"

namespace stream_recon {
namespace {

constexpr const char* kHolder =
    "the sheets of a chunk of the surface (a smaller --chunk-points needs less)";

/// Five at once, of few records.
SpoolOptions spool_options(const StageContext& context) {
  return {&context.scratch, &context.budget, std::uint64_t{1} << 20};
}

/// Before anything is made for the chunks.
const ExportedFacets& checked(const ExportedFacets& surface) {
  if (surface.layout().point_count > SurfaceSheets::kMostPoints) {
    throw InputError(fmt::format("{} points are more than --manifold takes, {}; leave it out",
                                 surface.layout().point_count, SurfaceSheets::kMostPoints));
  }
  return surface;
}

}  // namespace

SurfaceSheets::SurfaceSheets(const ExportedFacets& surface, const StageContext& context)
    : surface_(checked(surface)),
      context_(context),
      search_(surface, context),
      open_("sheet_stars", surface.layout().chunk_count(), spool_options(context)),
      touches_("sheet_touches", surface.layout().chunk_count(), spool_options(context)),
      corners_("sheet_corners", surface.layout().chunk_count(), spool_options(context)),
      turned_("sheet_turns", surface.layout().chunk_count(), spool_options(context)),
      uses_("sheet_uses", surface.layout().chunk_count(), spool_options(context)) {
  context_.progress.begin_stage("sheets", surface.layout().point_count, "points");
  find();
  open_.finish();
  touches_.finish();
  part();
  corners_.finish();
  turned_.finish();
  uses_.finish();
  context_.progress.end_stage();
}

void SurfaceSheets::find() {
  const ChunkLayout& layout = surface_.layout();
  std::uint64_t most = 0;
  for (std::uint64_t chunk = 0; chunk < layout.chunk_count(); ++chunk) {
    most = std::max(most, surface_.facets().count(chunk) + surface_.border_facets().count(chunk));
  }
  const std::uint64_t bytes = SheetSearch::typical_memory(most, layout.points_per_chunk);
  for_each_chunk(
      {.chunks = layout.chunk_count(),
       .at_once = chunks_at_once(bytes, context_.budget),
       .takes_in_order = true},
      [this](std::uint64_t chunk) { return search_.find(chunk); },
      [this](std::uint64_t chunk, const FoundSheets& found) { take(chunk, found); });
}

/// Rarely much: vertices at which a body or a cavity touches itself along an edge.
void SurfaceSheets::part() {
  for (std::uint64_t chunk = 0; chunk < surface_.layout().chunk_count(); ++chunk) {
    if (open_.count(chunk) == 0) continue;
    const Reservation memory = context_.budget.reserve(
        open_.count(chunk) * sizeof(StarTriangle) + touches_.count(chunk) * sizeof(SheetTouch),
        kHolder);
    const auto open = open_.records(chunk);
    auto touches = touches_.records(chunk);
    std::sort(touches.begin(), touches.end());
    const FoundSheets found = search_.part(open, touches);
    take_corners(chunk, found);
    for (const TurnedPair& pair : found.turned) turned_.append(chunk, pair);
    counts_.merge(found.counts);
  }
}

void SurfaceSheets::take(std::uint64_t chunk, const FoundSheets& found) {
  take_corners(chunk, found);
  counts_.merge(found.counts);
  for (const StarTriangle& triangle : found.open) open_.append(chunk, triangle);
  for (const SheetTouch& touch : found.touches) {
    touches_.append(surface_.layout().chunk_of(touch.vertex), touch);
  }
  context_.progress.advance(surface_.layout().points_in(chunk));
}

void SurfaceSheets::take_corners(std::uint64_t chunk, const FoundSheets& found) {
  for (const SheetCorner& corner : found.corners) {
    const std::uint64_t user = surface_.layout().chunk_of(corner.ranks[0]);
    corners_.append(user, corner);
    if (user != chunk) uses_.append(chunk, {sheet_key(corner.rank(), corner.sheet()), user});
  }
}

std::vector<SheetCorner> SurfaceSheets::corners(std::uint64_t chunk) const {
  auto corners = corners_.records(chunk);
  std::sort(corners.begin(), corners.end());
  return corners;
}

/// Both ends of an edge tell of it.
std::vector<TurnedPair> SurfaceSheets::turned_pairs(std::uint64_t chunk) const {
  auto pairs = turned_.records(chunk);
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

std::vector<BorderPoint> SurfaceSheets::border_points(std::uint64_t chunk) const {
  std::vector<BorderPoint> points = uses_.records(chunk);
  std::sort(points.begin(), points.end());
  const std::size_t split = points.size();
  const auto is_split = [&points, split](PointRank rank) {
    const auto end = points.begin() + static_cast<std::ptrdiff_t>(split);
    const auto at = std::lower_bound(points.begin(), end, BorderPoint{sheet_key(rank, 0), 0});
    return at != end && at->rank >> 32 == rank;
  };
  points.reserve(border_count(chunk));
  surface_.border_points().visit(chunk, [&](std::span<const BorderPoint> part) {
    for (const BorderPoint& point : part) {
      if (!is_split(point.rank)) points.push_back({sheet_key(point.rank, 0), point.user});
    }
  });
  return points;
}

void SurfaceSheets::correct(SurfaceCounts& counts) const {
  if (counts.nonmanifold_edges != counts_.split_edges) {
    throw std::logic_error(
        fmt::format("{} edges of the surface have more than two triangles, {} of them were split",
                    counts.nonmanifold_edges, counts_.split_edges));
  }
  counts.vertices += counts_.added_vertices;
  if (counts.vertices != counts.fans) {
    throw std::logic_error(
        fmt::format("{} vertices of the split surface have {} fans", counts.vertices, counts.fans));
  }
  counts.edges += counts_.added_edges;
  counts.nonmanifold_edges = 0;
}

}  // namespace stream_recon
