#include "engine/hybrid/enclosed_region.h"

#include <cstddef>
#include <utility>

#include "engine/hybrid/ring_walk.h"

namespace stream_recon {
namespace {

/// Of the side with less to start from, which is the likelier to be wrong.
constexpr int kSlowness = 3;

enum class Front : std::uint8_t { kNone, kInside, kOutside };

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
        fronts_(crust.triangles().size(), Front::kNone) {}

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

  void add_leaks(const Part& part, std::vector<std::uint32_t>& leaks) {
    std::vector<std::uint32_t> few = part.inside, many = part.outside;
    Front few_front = Front::kInside, many_front = Front::kOutside;
    if (few.size() > many.size()) {
      std::swap(few, many);
      std::swap(few_front, many_front);
    }
    for (const std::uint32_t t : few) fronts_[t] = few_front;
    for (const std::uint32_t t : many) fronts_[t] = many_front;
    while (!few.empty() || !many.empty()) {
      for (int step = 0; step < kSlowness; ++step) many = spread(many, many_front, leaks);
      few = spread(few, few_front, leaks);
    }
  }

  /// \return triangles reached; where the other front is beyond, the ends of the side are leaks
  std::vector<std::uint32_t> spread(const std::vector<std::uint32_t>& from, Front front,
                                    std::vector<std::uint32_t>& leaks) {
    std::vector<std::uint32_t> reached;
    for (const std::uint32_t t : from) {
      for (std::uint32_t side = 3 * t; side < 3 * t + 3; ++side) {
        if (walked_for_[side] != kNoEdge) {
          // A triangle between both sides of the walks is the outside's.
          if (fronts_[t] == Front::kOutside) leaks.push_back(crust_.from(side));
          continue;
        }
        if (is_end(side)) {
          if (fronts_[t] == Front::kInside) leaks.push_back(crust_.from(side));
          continue;
        }
        Front& beyond = fronts_[crust_.opposite(side) / 3];
        if (beyond == Front::kNone) {
          beyond = front;
          reached.push_back(crust_.opposite(side) / 3);
        } else if (beyond != fronts_[t]) {
          leaks.push_back(crust_.from(side));
        }
      }
    }
    return reached;
  }

  const CrustMesh& crust_;
  const std::vector<std::uint32_t>& walked_for_;
  std::vector<bool> is_done_;  ///< of triangles
  std::vector<Front> fronts_;  ///< of triangles
};

}  // namespace

EnclosedRegion enclosed_region(const CrustMesh& crust,
                               const std::vector<std::uint32_t>& walked_for) {
  return CrustParts(crust, walked_for).region();
}

}  // namespace stream_recon
