#include "engine/hybrid/patch_writer.h"

#include <algorithm>
#include <array>
#include <utility>

namespace stream_recon {
namespace {

FacetRecord facet_of(const HoleFill& fill, TriangleSource source) {
  return {.ranks = {fill.ranks[0], fill.ranks[1], fill.ranks[2]},
          .delta = fill.delta,
          .source = source,
          .facing = static_cast<Facing>(fill.facing),
          .closure = fill.closure};
}

/// As fills are ordered, and face.
HoleFill sorted_corners(const StoredHole& hole, HoleTriangle corners) {
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  const bool ascends = corners[1] < corners[2];
  if (!ascends) std::swap(corners[1], corners[2]);
  HoleFill fill{.hole = hole.number, .delta = kNoAngle, .closure = kUnknownClosure};
  for (int i = 0; i < 3; ++i) fill.ranks[i] = hole.ranks[corners[i]];
  fill.facing = static_cast<std::int8_t>(ascends ? Facing::kOutward : Facing::kInward);
  return fill;
}

}  // namespace

void PatchWriter::write(const StoredHole& hole, std::span<const HoleTriangle> patch) {
  facets_.clear();
  for (const HoleTriangle& triangle : patch) {
    const HoleFill fill = sorted_corners(hole, triangle);
    const auto at = std::lower_bound(hole.records.begin(), hole.records.end(), fill);
    const bool is_fill = at != hole.records.end() && at->ranks == fill.ranks;
    HoleFill known = is_fill ? *at : fill;
    known.facing = fill.facing;
    facets_.push_back(facet_of(known, TriangleSource::kPatch));
  }
  export_solid_facets(facets_, options_, out_);
}

void PatchWriter::write_fills(const StoredHole& hole) {
  facets_.clear();
  for (const HoleFill& fill : hole.records) {
    facets_.push_back(facet_of(fill, TriangleSource::kFill));
  }
  export_solid_facets(facets_, options_, out_);
}

}  // namespace stream_recon
