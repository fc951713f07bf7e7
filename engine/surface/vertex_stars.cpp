#include "engine/surface/vertex_stars.h"

#include <stdexcept>

namespace stream_recon {
namespace {

constexpr const char* kHolder =
    "the sheets of a chunk of the surface (a smaller --chunk-points needs less)";

}  // namespace

VertexStars::VertexStars(const ExportedFacets& surface, std::uint64_t chunk, MemoryBudget& budget)
    : places_(surface.layout().points_in(chunk)) {
  const std::uint64_t triangles =
      surface.facets().count(chunk) + surface.border_facets().count(chunk);
  const ChunkLayout& layout = surface.layout();
  memory_ = budget.reserve(memory(triangles, layout.points_in(chunk)), kHolder);
  facets_.reserve(triangles);
  const auto take_part = [this](std::span<const FacetRecord> records) { take(records); };
  surface.facets().visit(chunk, take_part);
  surface.border_facets().visit(chunk, take_part);
  sort_corners(layout.first_rank(chunk), layout.end_rank(chunk));
}

void VertexStars::take(std::span<const FacetRecord> records) {
  for (const FacetRecord& record : records) {
    if (record.facing == Facing::kUnknown) {
      throw std::logic_error("a facet that is to be split into sheets faces nowhere");
    }
    Facet& facet = facets_.emplace_back();
    for (int i = 0; i < 3; ++i) facet.ranks[i] = static_cast<ShortRank>(record.ranks[i]);
    facet.is_outward = record.facing == Facing::kOutward ? 1 : 0;
  }
}

void VertexStars::sort_corners(PointRank first, PointRank end) {
  const auto for_each_corner = [&](const auto& visit) {
    for (std::uint32_t f = 0; f < facets_.size(); ++f) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        const PointRank rank = facets_[f].ranks[i];
        if (rank >= first && rank < end) visit(rank - first, 3 * f + i);
      }
    }
  };
  std::size_t count = 0;
  for_each_corner([&](PointRank place, std::uint32_t) {
    places_.count(place);
    ++count;
  });
  places_.start();
  corners_.resize(count);
  for_each_corner(
      [this](PointRank place, std::uint32_t corner) { corners_[places_.slot(place)] = corner; });
}

void VertexStars::make_star(std::span<const std::uint32_t> corners,
                            std::vector<StarTriangle>& star) const {
  star.clear();
  for (const std::uint32_t corner : corners) {
    const Facet& facet = facets_[corner / 3];
    const auto& [a, b, c] = facet.ranks;
    switch (corner % 3) {
      case 0:
        star.push_back({a, b, c, facet.is_outward});
        break;
      case 1:
        star.push_back({b, a, c, 1 - facet.is_outward});
        break;
      default:
        star.push_back({c, a, b, facet.is_outward});
    }
  }
}

}  // namespace stream_recon
