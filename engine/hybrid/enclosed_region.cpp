#include "engine/hybrid/enclosed_region.h"

#include <cstddef>

#include "engine/hybrid/ring_walk.h"

namespace stream_recon {
namespace {

/// Triangles joined by sides without a walk, and the walks beside them.
struct Part {
  std::vector<std::uint32_t> triangles;
  std::vector<std::uint32_t> left_of, right_of;  ///< edges of the rings
  std::vector<std::uint32_t> ends;               ///< sides at the border of the piece
};

class CrustParts {
 public:
  CrustParts(const CrustMesh& crust, const std::vector<std::uint32_t>& walked_for)
      : crust_(crust), walked_for_(walked_for), is_done_(crust.triangles().size()) {}

  bool is_done(std::uint32_t triangle) const { return is_done_[triangle]; }

  Part part_at(std::uint32_t triangle) {
    Part part;
    enter(part, triangle);
    for (std::size_t i = 0; i < part.triangles.size(); ++i) {
      const std::uint32_t first = 3 * part.triangles[i];
      for (std::uint32_t side = first; side < first + 3; ++side) look_beyond(part, side);
    }
    return part;
  }

 private:
  void look_beyond(Part& part, std::uint32_t side) {
    const std::uint32_t beyond = crust_.opposite(side);
    if (walked_for_[side] != kNoEdge) {
      part.left_of.push_back(walked_for_[side]);
    } else if (beyond == kNoSide) {
      part.ends.push_back(side);
    } else if (walked_for_[beyond] != kNoEdge) {
      part.right_of.push_back(walked_for_[beyond]);
    } else if (!is_done_[beyond / 3]) {
      enter(part, beyond / 3);
    }
  }

  void enter(Part& part, std::uint32_t triangle) {
    is_done_[triangle] = true;
    part.triangles.push_back(triangle);
  }

  const CrustMesh& crust_;
  const std::vector<std::uint32_t>& walked_for_;
  std::vector<bool> is_done_;
};

}  // namespace

EnclosedRegion enclosed_region(const CrustMesh& crust,
                               const std::vector<std::uint32_t>& walked_for) {
  EnclosedRegion region;
  CrustParts parts(crust, walked_for);
  for (std::uint32_t side = 0; side < crust.side_count(); ++side) {
    if (walked_for[side] == kNoEdge || parts.is_done(side / 3)) continue;
    const Part part = parts.part_at(side / 3);
    const bool is_outside = part.left_of.size() <= part.right_of.size();
    const auto& astray = is_outside ? part.left_of : part.right_of;
    region.astray.insert(region.astray.end(), astray.begin(), astray.end());
    if (is_outside) continue;
    for (const std::uint32_t end : part.ends)
      region.gaps.push_back(crust.points()[crust.from(end)]);
    region.triangles.insert(region.triangles.end(), part.triangles.begin(), part.triangles.end());
  }
  return region;
}

}  // namespace stream_recon
