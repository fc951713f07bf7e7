#include "engine/hybrid/enclosed_region.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

#include "engine/hybrid/ring_walk.h"

namespace stream_recon {
namespace {

constexpr std::uint32_t kFar = std::numeric_limits<std::uint32_t>::max();

/// Triangles joined by sides without a walk; those at the left of walks, and those at the right or
/// at the border of the piece.
struct Part {
  std::vector<std::uint32_t> triangles;
  std::vector<std::uint32_t> inside, outside;
};

class CrustParts {
 public:
  CrustParts(const CrustMesh& crust, const std::vector<std::uint32_t>& walked_for)
      : crust_(crust),
        walked_for_(walked_for),
        is_done_(crust.triangles().size()),
        from_inside_(crust.triangles().size(), kFar),
        from_outside_(crust.triangles().size(), kFar) {}

  EnclosedRegion region() {
    EnclosedRegion region;
    for (std::uint32_t side = 0; side < crust_.side_count(); ++side) {
      if (walked_for_[side] == kNoEdge || is_done_[side / 3]) continue;
      const Part part = part_at(side / 3);
      if (part.outside.empty()) {
        region.triangles.insert(region.triangles.end(), part.triangles.begin(),
                                part.triangles.end());
      } else {
        add_leaks(part, region.leaks);
      }
    }
    return region;
  }

 private:
  Part part_at(std::uint32_t triangle) {
    Part part;
    is_done_[triangle] = true;
    part.triangles.push_back(triangle);
    for (std::size_t i = 0; i < part.triangles.size(); ++i) {
      const std::uint32_t first = 3 * part.triangles[i];
      for (std::uint32_t side = first; side < first + 3; ++side) look_beyond(part, side);
    }
    return part;
  }

  void look_beyond(Part& part, std::uint32_t side) {
    const std::uint32_t beyond = crust_.opposite(side);
    if (walked_for_[side] != kNoEdge) {
      part.inside.push_back(side / 3);
    } else if (is_end(side)) {
      part.outside.push_back(side / 3);
    } else if (!is_done_[beyond / 3]) {
      is_done_[beyond / 3] = true;
      part.triangles.push_back(beyond / 3);
    }
  }

  /// Seen from the right of a walk, or at the border.
  bool is_end(std::uint32_t side) const {
    const std::uint32_t beyond = crust_.opposite(side);
    return beyond == kNoSide || walked_for_[beyond] != kNoEdge;
  }

  /// Of all levels between inside and outside the one with the fewest sides across.
  void add_leaks(const Part& part, std::vector<std::uint32_t>& leaks) {
    spread(part.inside, from_inside_);
    spread(part.outside, from_outside_);
    std::vector<std::pair<double, int>> steps;  // up where sides begin to cross a level
    for_sides_across(part, [&](std::uint32_t, double low, double high) {
      steps.emplace_back(low, 1);
      steps.emplace_back(high, -1);
    });
    std::sort(steps.begin(), steps.end());
    double level = 0.5;
    int across = 0;
    int fewest = std::numeric_limits<int>::max();
    for (std::size_t i = 0; i + 1 < steps.size(); ++i) {
      across += steps[i].second;
      if (!(steps[i].first < steps[i + 1].first) || across >= fewest) continue;
      fewest = across;
      level = (steps[i].first + steps[i + 1].first) / 2;
    }
    for_sides_across(part, [&](std::uint32_t side, double low, double high) {
      if (low < level && level < high) leaks.push_back(crust_.from(side));
    });
    // Inside and outside at once.
    for (const std::uint32_t t : part.inside) {
      if (from_outside_[t] == 0) leaks.push_back(crust_.from(3 * t));
    }
  }

  /// 0 inside, 1 outside.
  double level_of(std::uint32_t triangle) const {
    const double inside = from_inside_[triangle];
    const double all = inside + from_outside_[triangle];
    return all > 0 ? inside / all : 0.5;
  }

  template <class Visit>
  void for_sides_across(const Part& part, const Visit& visit) const {
    for (const std::uint32_t t : part.triangles) {
      const double here = level_of(t);
      for (std::uint32_t side = 3 * t; side < 3 * t + 3; ++side) {
        if (walked_for_[side] != kNoEdge || is_end(side)) continue;
        const double there = level_of(crust_.opposite(side) / 3);
        if (here < there) visit(side, here, there);
      }
    }
  }

  /// Steps from the triangles, over the part.
  void spread(const std::vector<std::uint32_t>& from, std::vector<std::uint32_t>& steps) const {
    std::vector<std::uint32_t> reached = from;
    for (const std::uint32_t t : from) steps[t] = 0;
    for (std::size_t i = 0; i < reached.size(); ++i) {
      const std::uint32_t t = reached[i];
      for (std::uint32_t side = 3 * t; side < 3 * t + 3; ++side) {
        if (walked_for_[side] != kNoEdge || is_end(side)) continue;
        const std::uint32_t beyond = crust_.opposite(side) / 3;
        if (steps[beyond] != kFar) continue;
        steps[beyond] = steps[t] + 1;
        reached.push_back(beyond);
      }
    }
  }

  const CrustMesh& crust_;
  const std::vector<std::uint32_t>& walked_for_;
  std::vector<bool> is_done_;  ///< of triangles, like the next two
  std::vector<std::uint32_t> from_inside_;
  std::vector<std::uint32_t> from_outside_;
};

}  // namespace

EnclosedRegion enclosed_region(const CrustMesh& crust,
                               const std::vector<std::uint32_t>& walked_for) {
  return CrustParts(crust, walked_for).region();
}

}  // namespace stream_recon
