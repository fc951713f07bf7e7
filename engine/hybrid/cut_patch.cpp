#include "engine/hybrid/cut_patch.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "engine/hybrid/crust_mesh.h"
#include "engine/hybrid/enclosed_region.h"
#include "engine/hybrid/hole_part.h"
#include "engine/hybrid/hole_rings.h"
#include "engine/hybrid/patch_check.h"
#include "spatial/neighbors.h"
#include "spatial/vector.h"

namespace stream_recon {
namespace {

using Rings = std::vector<std::vector<std::uint32_t>>;

/// Rounds that keep only fills at both ends of an edge in trouble.
constexpr int kSparingRounds = 4;

double area_of(const Hole& hole, const std::vector<HoleTriangle>& triangles) {
  double twice = 0;
  for (const HoleTriangle& t : triangles) {
    const Point3& a = hole.points[t[0]];
    twice += length(cross(minus(hole.points[t[1]], a), minus(hole.points[t[2]], a)));
  }
  return twice / 2;
}

class PatchCutter {
 public:
  PatchCutter(const Hole& hole, const Rings& rings, const CrustPiece& crust,
              const PatchOptions& options)
      : hole_(hole), rings_(rings), options_(options), crust_(crust), is_kept_(hole.fills.size()) {}

  std::optional<Patch> run() {
    for (int round = 0; round < options_.most_rounds; ++round) {
      if (cut()) return patch();
      if (round == 0) {
        crust_ = CrustMesh(crust_.subdivided());
        continue;
      }
      if (!keep_at_trouble(round < kSparingRounds)) return std::nullopt;
    }
    return std::nullopt;
  }

 private:
  /// Triangles of the patch, or edges in trouble.
  bool cut() {
    trouble_.clear();
    const HolePart part = hole_without(hole_, is_kept_);
    const Rings rings = hole_rings(part.hole);
    RingWalks walks = walk_rings(part.hole, rings, crust_, options_.walk);
    const auto in_whole = [&](const HoleEdge& edge) {
      return HoleEdge{part.numbers[edge[0]], part.numbers[edge[1]]};
    };
    for (const HoleEdge& edge : walks.failed) trouble_.push_back(in_whole(edge));
    if (!trouble_.empty()) return false;
    const EnclosedRegion region = enclosed_region(crust_, walks.walked_for);
    if (!region.leaks.empty()) add_leaks(region.leaks, part);
    if (!trouble_.empty()) return false;
    triangles_ = merged_patch(part.hole, crust_, region.triangles, std::move(walks.sample_of),
                              options_.merge);
    for (HoleTriangle& t : triangles_) {
      for (std::uint32_t& corner : t) corner = part.numbers[corner];
    }
    for (std::size_t i = 0; i < is_kept_.size(); ++i) {
      if (is_kept_[i]) triangles_.push_back(hole_.fills[i]);
    }
    triangles_ = reduced_chain(triangles_);
    trouble_ = misfits(triangles_, hole_, rings_);
    return trouble_.empty();
  }

  /// The samples beside them that the part still has.
  void add_leaks(std::vector<std::uint32_t> leaks, const HolePart& part) {
    std::sort(leaks.begin(), leaks.end());
    leaks.erase(std::unique(leaks.begin(), leaks.end()), leaks.end());
    const Neighbors samples(part.hole.points);
    for (const std::uint32_t leak : leaks) {
      const std::uint32_t sample = samples.nearest(crust_.points()[leak], 1).front().index;
      trouble_.push_back({part.numbers[sample], part.numbers[sample]});
    }
  }

  std::optional<Patch> patch() {
    if (area_of(hole_, triangles_) > options_.most_area * area_of(hole_, hole_.fills)) {
      return std::nullopt;
    }
    const auto count = static_cast<std::uint32_t>(hole_.points.size());
    const std::uint32_t unused = unused_points(triangles_, count);
    return Patch{PatchKind::kCrust, std::move(triangles_), unused, kept_};
  }

  /// \return whether more are kept than before, and not too many
  bool keep_at_trouble(bool is_sparing) {
    std::vector<bool> is_end(hole_.points.size());
    for (HoleEdge& edge : trouble_) {
      if (edge[0] > edge[1]) std::swap(edge[0], edge[1]);
      is_end[edge[0]] = is_end[edge[1]] = true;
    }
    std::sort(trouble_.begin(), trouble_.end());
    const auto before = kept_;
    keep_if([&](const HoleTriangle& fill) {
      return is_sparing ? is_in_trouble(fill)
                        : std::any_of(fill.begin(), fill.end(),
                                      [&](std::uint32_t corner) { return is_end[corner]; });
    });
    if (kept_ == before && is_sparing) return keep_at_trouble(false);
    return kept_ > before &&
           static_cast<double>(kept_) <= options_.most_kept * static_cast<double>(is_kept_.size());
  }

  bool is_in_trouble(const HoleTriangle& fill) const {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(fill[i], fill[(i + 1) % 3]);
      if (std::binary_search(trouble_.begin(), trouble_.end(), HoleEdge{low, high})) return true;
    }
    return false;
  }

  template <class Test>
  void keep_if(const Test& test) {
    for (std::size_t i = 0; i < is_kept_.size(); ++i) {
      if (is_kept_[i] || !test(hole_.fills[i])) continue;
      is_kept_[i] = true;
      ++kept_;
    }
  }

  const Hole& hole_;
  const Rings& rings_;
  const PatchOptions& options_;
  CrustMesh crust_;
  std::vector<bool> is_kept_;  ///< of fills
  std::uint32_t kept_ = 0;
  std::vector<HoleTriangle> triangles_;
  std::vector<HoleEdge> trouble_;
};

}  // namespace

std::optional<Patch> cut_patch(const Hole& hole, const Rings& rings, const CrustPiece& crust,
                               const PatchOptions& options) {
  return PatchCutter(hole, rings, crust, options).run();
}

}  // namespace stream_recon
