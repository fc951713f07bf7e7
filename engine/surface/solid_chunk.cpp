#include "engine/surface/solid_chunk.h"

#include <algorithm>
#include <array>
#include <utility>

#include "engine/surface/chunk_stars.h"
#include "engine/surface/edge_wedges.h"
#include "engine/surface/piece_forest.h"
#include "spatial/vector.h"

namespace stream_recon {
namespace {

/// Its position, rank, coordinates and input index.
constexpr std::uint64_t kCrowdedPoint = 44;

using Pair = std::array<std::uint32_t, 2>;  ///< positions among the uses of an edge

class SolidChunkExamination {
 public:
  SolidChunkExamination(const SolidChunkInput& input, const SolidPoints& points)
      : points_(points),
        scale_(points.range.scale().value_or(1)),
        predicates_(points.range.times(scale_)),
        turned_(input.turned),
        stars_(input.own, input.border),
        first_(stars_.position(input.first)),
        end_(stars_.position(input.end)),
        uses_(sorted_edge_uses(stars_.triangles)),
        pieces_(stars_.own),
        corners_(3 * stars_.triangles.size()),
        is_open_(stars_.own, false) {}

  SolidChunk run() {
    read_crowded_points();
    count_vertices();
    for_each_edge(uses_, [this](std::span<const EdgeUse> uses) { visit(uses); });
    result_.counts.fans = own_corners_ - joined_corners_;
    finish_pieces();
    return std::move(result_);
  }

 private:
  bool is_own_point(std::uint32_t position) const { return position >= first_ && position < end_; }
  bool is_own(const EdgeUse& use) const { return stars_.is_own(use); }
  /// Whether all triangles at the edge are known here.
  bool is_known(const EdgeUse& edge) const {
    return is_own_point(edge.low) || is_own_point(edge.high);
  }
  std::uint32_t apex(const EdgeUse& use) const { return stars_.apex(use); }

  /// The points at edges of more than two triangles, where angles decide.
  void read_crowded_points() {
    std::vector<bool> is_crowded(stars_.ranks.size(), false);
    for_each_edge(uses_, [&](std::span<const EdgeUse> uses) {
      if (uses.size() <= 2 || !is_known(uses[0])) return;
      is_crowded[uses[0].low] = is_crowded[uses[0].high] = true;
      for (const EdgeUse& use : uses) is_crowded[apex(use)] = true;
    });
    const auto count =
        static_cast<std::size_t>(std::count(is_crowded.begin(), is_crowded.end(), true));
    if (count == 0) return;
    crowded_memory_ = points_.budget.reserve(count * kCrowdedPoint, "edges of many triangles");
    crowded_.reserve(count);
    std::vector<PointRank> ranks;
    ranks.reserve(count);
    for (std::uint32_t i = 0; i < is_crowded.size(); ++i) {
      if (!is_crowded[i]) continue;
      crowded_.push_back(i);
      ranks.push_back(stars_.ranks[i]);
    }
    std::vector<std::uint64_t> input_indices;
    read_points(points_.store, ranks, crowded_points_, input_indices);
    for (Point3& point : crowded_points_) point = scaled(point, scale_);
  }

  const Point3& crowded_point(std::uint32_t position) const {
    const auto at = std::lower_bound(crowded_.begin(), crowded_.end(), position);
    return crowded_points_[static_cast<std::size_t>(at - crowded_.begin())];
  }

  void count_vertices() {
    result_.counts.vertices = end_ - first_;
    for (const LocalTriangle& v : stars_.triangles) {
      for (const std::uint32_t position : v) own_corners_ += is_own_point(position) ? 1 : 0;
    }
  }

  void visit(std::span<const EdgeUse> uses) {
    if (!is_known(uses[0])) {
      // Of a later chunk, which will pair its triangles; or of earlier ones alone.
      std::copy_if(uses.begin(), uses.end(), std::back_inserter(shared_),
                   [this](const EdgeUse& use) { return is_own(use); });
      return;
    }
    const std::vector<Pair>& pairs = find_pairs(uses);
    for (const auto& [a, b] : pairs) join_corners(uses[a], uses[b]);
    if (is_own_point(uses[0].low)) count_edge(uses, pairs);
  }

  const std::vector<Pair>& find_pairs(std::span<const EdgeUse> uses) {
    pairs_.clear();
    if (uses.size() == 2) {
      if (stars_.rises(uses[0]) != stars_.rises(uses[1])) pairs_.push_back({0, 1});
    } else if (uses.size() > 2 && !find_turned_pairs(uses)) {
      sides_.clear();
      for (std::uint32_t i = 0; i < uses.size(); ++i) {
        const std::uint32_t third = apex(uses[i]);
        sides_.push_back({crowded_point(third), stars_.ranks[third], stars_.rises(uses[i]), i});
      }
      pairs_ = inside_wedges({crowded_point(uses[0].low), crowded_point(uses[0].high)}, sides_,
                             predicates_);
    }
    return pairs_;
  }

  /// Whether the edge is one where the inside does not decide.
  bool find_turned_pairs(std::span<const EdgeUse> uses) {
    const auto low = static_cast<ShortRank>(stars_.ranks[uses[0].low]);
    const auto high = static_cast<ShortRank>(stars_.ranks[uses[0].high]);
    const auto place_of = [&](ShortRank third, bool rises) {
      const auto at = std::find_if(uses.begin(), uses.end(), [&](const EdgeUse& use) {
        return stars_.ranks[apex(use)] == third && stars_.rises(use) == rises;
      });
      return static_cast<std::uint32_t>(at - uses.begin());
    };
    auto pair = std::lower_bound(turned_.begin(), turned_.end(), TurnedPair{low, high, {}});
    for (; pair != turned_.end() && pair->low == low && pair->high == high; ++pair) {
      pairs_.push_back({place_of(pair->thirds[0], false), place_of(pair->thirds[1], true)});
    }
    return !pairs_.empty();
  }

  /// Joins what two triangles are around the ends of their edge, where these are the chunk's.
  void join_corners(const EdgeUse& a, const EdgeUse& b) {
    for (const std::uint32_t end : {a.low, a.high}) {
      if (!is_own_point(end)) continue;
      if (corners_.join(corner(a, end), corner(b, end))) ++joined_corners_;
    }
  }

  std::uint32_t corner(const EdgeUse& use, std::uint32_t position) const {
    const LocalTriangle& v = stars_.triangles[use.triangle()];
    const auto at = std::find(v.begin(), v.end(), position);
    return 3 * use.triangle() + static_cast<std::uint32_t>(at - v.begin());
  }

  void count_edge(std::span<const EdgeUse> uses, const std::vector<Pair>& pairs) {
    SolidCounts& counts = result_.counts;
    ++counts.edges;
    if (uses.size() == 1) ++counts.boundary_edges;
    if (uses.size() > 2) ++counts.nonmanifold_edges;
    counts.unpaired_uses += uses.size() - 2 * pairs.size();
    for (const auto& [a, b] : pairs) {
      if (is_own(uses[a]) && is_own(uses[b])) pieces_.join(uses[a].triangle(), uses[b].triangle());
    }
    if (uses.size() != 2 * pairs.size()) open(uses, pairs);
    // Own uses stand first, since own triangles do.
    if (is_own(uses.back())) return;
    std::copy_if(uses.begin(), uses.end(), std::back_inserter(shared_),
                 [this](const EdgeUse& use) { return is_own(use); });
    if (uses.size() == 2) return;
    for (const auto& [a, b] : pairs) {
      result_.pieces.told.push_back(
          SharedEdge::wedge(edge_of(uses[a]), stars_.ranks[apex(uses[b])]));
    }
  }

  void open(std::span<const EdgeUse> uses, const std::vector<Pair>& pairs) {
    for (std::uint32_t i = 0; i < uses.size(); ++i) {
      const bool is_paired = std::any_of(pairs.begin(), pairs.end(),
                                         [i](const Pair& p) { return p[0] == i || p[1] == i; });
      if (!is_paired && is_own(uses[i])) is_open_[uses[i].triangle()] = true;
    }
  }

  SharedEdge edge_of(const EdgeUse& use) const {
    return edge_of_use(use, stars_.triangles[use.triangle()], stars_.ranks);
  }

  void finish_pieces() {
    std::vector<SharedEdge> wedges = std::move(result_.pieces.told);
    result_.pieces = number_pieces(pieces_.take_roots(), shared_);
    ChunkPieces& pieces = result_.pieces;
    pieces.told = std::move(wedges);
    for (const EdgeUse& use : shared_) {
      pieces.told.push_back(
          SharedEdge::use(edge_of(use), pieces.of_triangle[use.triangle()], stars_.rises(use)));
    }
    pieces.facts.resize(pieces.count);
    for (std::uint32_t t = 0; t < stars_.own; ++t) {
      if (is_open_[t]) pieces.facts[pieces.of_triangle[t]].is_open = true;
    }
  }

  const SolidPoints& points_;
  const double scale_;  ///< of coordinates, for the predicates
  const Predicates predicates_;
  const std::span<const TurnedPair> turned_;
  const ChunkStars stars_;
  const std::uint32_t first_;  ///< positions of the chunk's own points, and their end
  const std::uint32_t end_;
  const std::vector<EdgeUse> uses_;
  PieceForest<std::uint32_t> pieces_;   ///< of own triangles
  PieceForest<std::uint32_t> corners_;  ///< 3 * triangle + corner, joined around the chunk's points
  std::vector<bool> is_open_;           ///< of own triangles
  std::uint64_t own_corners_ = 0;
  std::uint64_t joined_corners_ = 0;
  Reservation crowded_memory_;
  std::vector<std::uint32_t> crowded_;  ///< positions of points at edges of more than two triangles
  std::vector<Point3> crowded_points_;
  std::vector<EdgeUse> shared_;
  std::vector<Pair> pairs_;
  std::vector<WedgeSide> sides_;
  SolidChunk result_;
};

}  // namespace

SolidChunk examine_solid_chunk(const SolidChunkInput& input, const SolidPoints& points) {
  return SolidChunkExamination(input, points).run();
}

}  // namespace stream_recon
