#include "engine/surface/edge_wedges.h"

#include <algorithm>
#include <functional>
#include <tuple>

namespace stream_recon {
namespace {

using Wedges = std::vector<std::array<std::uint32_t, 2>>;

/// Whether two sides run away from the edge in one direction, or one in none, so that there is no
/// order of turn. \param sides first, then those up to half a turn from it, from `half` on the rest
template <class Turn>
bool overlap(std::span<const WedgeSide> sides, std::size_t half, const Turn& turn) {
  for (std::size_t i = 2; i < sides.size(); ++i) {
    if (i != half && turn(sides[i - 1].apex, sides[i].apex) <= 0) return true;
  }
  // Of a side in the plane of the first another one tells whether it is opposite.
  const Point3& first = sides[0].apex;
  const auto apart = std::find_if(sides.begin(), sides.end(), [&](const WedgeSide& side) {
    return turn(first, side.apex) != 0;
  });
  if (apart == sides.end()) return true;
  return std::any_of(sides.begin() + 1, sides.end(), [&](const WedgeSide& side) {
    return turn(first, side.apex) == 0 && turn(side.apex, apart->apex) != -turn(first, apart->apex);
  });
}

/// The same pairs, whatever the order of the sides.
Wedges pairs_without_turn(std::span<WedgeSide> sides) {
  std::sort(sides.begin(), sides.end(), [](const WedgeSide& a, const WedgeSide& b) {
    return std::tie(a.rises, a.apex, a.rank) < std::tie(b.rises, b.apex, b.rank);
  });
  const std::size_t half = sides.size() / 2;
  Wedges wedges;
  for (std::size_t i = 0; i < half; ++i) {
    wedges.push_back({sides[i].name, sides[half + i].name});
  }
  return wedges;
}

}  // namespace

std::vector<std::array<std::uint32_t, 2>> inside_wedges(const std::array<Point3, 2>& edge,
                                                        std::span<WedgeSide> sides,
                                                        const Predicates& predicates) {
  Wedges wedges;
  if (sides.size() < 2) return wedges;
  const auto turn = [&](const Point3& from, const Point3& to) {
    return predicates.orient3d(edge[0], edge[1], from, to);
  };
  // Counterclockwise from the first side on: up to half a turn, then beyond.
  const Point3 first = sides[0].apex;
  const auto is_beyond = [&](const WedgeSide& side) { return turn(first, side.apex) <= 0; };
  const auto begin = sides.begin() + 1;
  const auto half = std::partition(begin, sides.end(), std::not_fn(is_beyond));
  const auto is_before = [&](const WedgeSide& a, const WedgeSide& b) {
    return turn(a.apex, b.apex) > 0;
  };
  std::sort(begin, half, is_before);
  std::sort(half, sides.end(), is_before);

  const auto rising =
      std::count_if(sides.begin(), sides.end(), [](const WedgeSide& side) { return side.rises; });
  const bool is_closed = 2 * static_cast<std::size_t>(rising) == sides.size();
  if (is_closed && sides.size() > 2 &&
      overlap(sides, static_cast<std::size_t>(half - sides.begin()), turn)) {
    return pairs_without_turn(sides);
  }
  // Counterclockwise, the inside begins behind a side that falls and ends before one that rises.
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const WedgeSide& next = sides[(i + 1) % sides.size()];
    if (!sides[i].rises && next.rises) wedges.push_back({sides[i].name, next.name});
  }
  if (is_closed && 2 * wedges.size() != sides.size()) return pairs_without_turn(sides);
  return wedges;
}

}  // namespace stream_recon
