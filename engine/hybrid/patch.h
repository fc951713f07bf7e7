// A patch for a hole of the gamma shape: triangles between its samples, cut from the crust.
//
// Where a walk fails, or a part of the patch would not fit, the fills at that place are kept and
// the rest of the hole is tried again. Guarantees: the border of a patch is the hole's, edge by
// edge and in its direction; every other edge has two triangles, or no more than the fills have
// there; no vertex is added. So it fits without cracks. No facet outside the hole, as far as
// the hole tells of them, is there again or has its edges used. Same hole and crust, same patch.
// Thread rule: pure. Memory: 200 bytes a triangle of the crust, four times that where it is
// subdivided. Cost of a round: n log n, about 1 us a triangle of the crust; most holes need one.
// Source: thesis, 2007, chapter 6; docs/algorithms/hybrid.md
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/hybrid/crust_piece.h"
#include "engine/hybrid/hole.h"
#include "engine/hybrid/merged_patch.h"
#include "engine/hybrid/ring_walk.h"

namespace stream_recon {

/// Of a ring that is closed by triangles between its own vertices alone.
inline constexpr std::size_t kMostRingEdges = 24;

enum class PatchKind : std::uint8_t {
  kCrust,      ///< a region of the crust
  kTriangles,  ///< over the ring alone
  kNone
};

struct Patch {
  PatchKind kind = PatchKind::kNone;
  std::vector<HoleTriangle> triangles;
  std::uint32_t unused_samples = 0;  ///< points of the hole that no triangle has
  std::uint32_t kept_fills = 0;      ///< of a patch from the crust: fills it has where that failed
};

struct PatchOptions {
  RingWalkOptions walk;
  MergeOptions merge;
  double most_area = 4;     ///< of a patch, in areas of the fills: others went astray
  int most_rounds = 40;     ///< of keeping fills where the crust is of no use
  double most_kept = 0.67;  ///< share of the fills: with more it is no patch of the crust
};

Patch make_patch(const Hole& hole, const CrustPiece& crust, const PatchOptions& options = {});

/// Without a crust: for one ring of at most kMostRingEdges edges and no sample inside, triangles
/// over the ring alone: of least area among those with the fewest inner edges that no fill has.
std::optional<Patch> close_by_triangles(const Hole& hole);

}  // namespace stream_recon
