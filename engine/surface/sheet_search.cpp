#include "engine/surface/sheet_search.h"

#include <algorithm>
#include <utility>

#include "engine/surface/vertex_stars.h"

namespace stream_recon {
namespace {

constexpr const char* kHolder =
    "the sheets of a chunk of the surface (a smaller --chunk-points needs less)";

/// Triangles of stars that are looked at together, so that points are read from few blocks.
constexpr std::size_t kBatch = 8192;
/// A triangle of a star; up to three ranks and points, with their input indices and, while the
/// lists grow, twice.
constexpr std::uint64_t kBatchTriangle = 160;
/// A point store's cursor and a chunk's reader.
constexpr std::uint64_t kFixedBytes = std::uint64_t{1} << 20;

/// Calls visit(star) for each of the stars that stand one after the other.
template <class Visit>
void for_each_star(std::span<const StarTriangle> stars, const Visit& visit) {
  for (std::size_t begin = 0; begin < stars.size();) {
    std::size_t end = begin + 1;
    while (end < stars.size() && stars[end].vertex == stars[begin].vertex) ++end;
    visit(stars.subspan(begin, end - begin));
    begin = end;
  }
}

SheetCorner corner_of(const StarTriangle& t, std::uint32_t sheet) {
  const std::uint32_t corner = t.vertex < t.low ? 0 : t.vertex < t.high ? 1 : 2;
  // An odd turn of the order.
  const bool is_outward = (t.is_outward != 0) != (corner == 1);
  const std::uint32_t place = 4 * sheet + corner + (is_outward ? SheetCorner::kOutward : 0);
  if (corner == 0) return {{t.vertex, t.low, t.high}, place};
  if (corner == 1) return {{t.low, t.vertex, t.high}, place};
  return {{t.low, t.high, t.vertex}, place};
}

std::span<const SheetTouch> touches_of(ShortRank vertex, std::span<const SheetTouch> touches) {
  const auto begin = std::partition_point(
      touches.begin(), touches.end(), [vertex](const SheetTouch& t) { return t.vertex < vertex; });
  const auto end = std::partition_point(
      begin, touches.end(), [vertex](const SheetTouch& t) { return t.vertex == vertex; });
  return {begin, end};
}

/// Stars collected until it is worth while to read their points.
class StarBatch {
 public:
  StarBatch(const PointStoreFile& store, const StageContext& context, FoundSheets& found)
      : store_(store),
        context_(context),
        found_(found),
        memory_(context.budget.reserve(kFixedBytes + kBatch * kBatchTriangle, kHolder)) {
    found_.memory = context.budget.reserve(0, kHolder);
  }

  /// Calls settle(star, sheets) once the points are there, at the latest in finish().
  template <class Settle>
  void add(std::span<const StarTriangle> star, const Settle& settle) {
    if (stars_.size() + star.size() > kBatch) finish(settle);
    const std::uint64_t most = std::max(kBatch, stars_.size() + star.size());
    if (most > kBatch) memory_.resize(kFixedBytes + most * kBatchTriangle);
    const auto added = stars_.insert(stars_.end(), star.begin(), star.end());
    std::sort(added, stars_.end());
  }

  template <class Settle>
  void finish(const Settle& settle) {
    context_.stop.check();
    if (stars_.empty()) return;
    reserve_findings();
    const RankedPoints points = read();
    for_each_star(stars_, [&](std::span<const StarTriangle> star) {
      settle(star, VertexSheets(star, points));
    });
    stars_.clear();
  }

 private:
  /// A triangle becomes a corner and perhaps part of two pairs, or waits with two touches; while
  /// the lists grow, twice.
  void reserve_findings() {
    const std::uint64_t records = found_.corners.size() + found_.open.size() +
                                  found_.touches.size() + found_.turned.size() + 3 * stars_.size();
    found_.memory.resize(2 * records * sizeof(SheetCorner));
  }

  RankedPoints read() const {
    std::vector<PointRank> ranks;
    ranks.reserve(3 * stars_.size());
    for (const StarTriangle& t : stars_) {
      for (const PointRank rank : {t.vertex, t.low, t.high}) ranks.push_back(rank);
    }
    std::sort(ranks.begin(), ranks.end());
    ranks.erase(std::unique(ranks.begin(), ranks.end()), ranks.end());
    std::vector<Point3> points;
    std::vector<std::uint64_t> ids;
    read_points(store_, ranks, points, ids);
    return {std::move(ranks), std::move(points)};
  }

  const PointStoreFile& store_;
  const StageContext& context_;
  FoundSheets& found_;
  Reservation memory_;
  std::vector<StarTriangle> stars_;
};

/// Notes a vertex of which all is known.
void settle(std::span<const StarTriangle> star, const VertexSheets& sheets, FoundSheets& found) {
  found.counts.split_edges += sheets.multiple_edges();
  found.counts.added_edges += sheets.added_edges();
  if (sheets.count() < 2) return;
  found.counts.added_vertices += sheets.count() - 1;
  for (std::size_t t = 0; t < star.size(); ++t) {
    found.corners.push_back(corner_of(star[t], sheets.sheets()[t]));
  }
}

}  // namespace

std::uint64_t SheetSearch::typical_memory(std::uint64_t triangles, std::uint64_t points) {
  return VertexStars::memory(triangles, points) + 2 * kFixedBytes + kBatch * kBatchTriangle +
         ExportReader::read_memory();
}

FoundSheets SheetSearch::find(std::uint64_t chunk) const {
  context_.stop.check();
  FoundSheets found;
  const VertexStars stars(surface_, chunk, context_.budget);
  StarBatch batch(store_, context_, found);
  const auto look = [&found](std::span<const StarTriangle> star, const VertexSheets& sheets) {
    const std::vector<SheetTouch> touches = sheets.touches();
    if (touches.empty()) return settle(star, sheets, found);
    found.open.insert(found.open.end(), star.begin(), star.end());
    found.touches.insert(found.touches.end(), touches.begin(), touches.end());
  };
  stars.for_each([&](std::span<const StarTriangle> star) {
    if (!is_closed_fan(star)) batch.add(star, look);
  });
  batch.finish(look);
  return found;
}

FoundSheets SheetSearch::part(std::span<const StarTriangle> open,
                              std::span<const SheetTouch> touches) const {
  FoundSheets found;
  StarBatch batch(store_, context_, found);
  const auto look = [&](std::span<const StarTriangle> star, VertexSheets sheets) {
    sheets.part(touches_of(star[0].vertex, touches));
    settle(star, sheets, found);
    const std::vector<TurnedPair> turned = sheets.turned_pairs();
    found.turned.insert(found.turned.end(), turned.begin(), turned.end());
  };
  for_each_star(open, [&](std::span<const StarTriangle> star) { batch.add(star, look); });
  batch.finish(look);
  return found;
}

}  // namespace stream_recon
