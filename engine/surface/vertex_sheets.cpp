#include "engine/surface/vertex_sheets.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "engine/surface/edge_wedges.h"

namespace stream_recon {
namespace {

/// Walking the fan looks at all triangles left for each.
constexpr std::size_t kMostWalked = 48;

/// Triangles joined into sheets; the root is the lowest of a sheet.
class Joined {
 public:
  explicit Joined(std::size_t triangles) : parent_(triangles) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }

  std::uint32_t root(std::uint32_t t) {
    while (parent_[t] != t) t = parent_[t] = parent_[parent_[t]];
    return t;
  }
  void join(std::array<std::uint32_t, 2> wedge) {
    const auto [low, high] = std::minmax({root(wedge[0]), root(wedge[1])});
    parent_[high] = low;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

/// A wedge with its sheets at both ends of its edge.
struct TwoSheets {
  std::uint32_t here = 0;
  std::uint32_t there = 0;
  std::uint32_t wedge = 0;

  bool has_sheets_of(const TwoSheets& o) const { return here == o.here && there == o.there; }
  friend bool operator<(const TwoSheets& a, const TwoSheets& b) {
    return std::tie(a.here, a.there, a.wedge) < std::tie(b.here, b.there, b.wedge);
  }
};

/// Joins the end of each wedge to the beginning of the next: what they bound outside.
void turn_outside(std::span<const TwoSheets> alike,
                  std::vector<std::array<std::uint32_t, 2>>& wedges) {
  for (std::size_t i = 0; i + 1 < alike.size(); ++i) {
    std::swap(wedges[alike[i].wedge][0], wedges[alike[i + 1].wedge][0]);
  }
}

[[noreturn]] void fail_open() {
  throw std::logic_error("a surface that is to be split into sheets is not closed");
}

}  // namespace

/// Walks from triangle to triangle; at each edge exactly one must be left to go on with.
bool is_closed_fan(std::span<const StarTriangle> star) {
  using Ends = std::pair<ShortRank, ShortRank>;
  const std::size_t count = star.size();
  if (count < 3 || count > kMostWalked) return false;
  std::array<Ends, kMostWalked> ends;
  for (std::size_t i = 0; i < count; ++i) ends[i] = {star[i].low, star[i].high};
  ShortRank at = ends[0].second;
  for (std::size_t done = 1; done < count; ++done) {
    std::size_t next = 0;
    std::size_t found = 0;
    for (std::size_t i = done; i < count; ++i) {
      if (ends[i].first != at && ends[i].second != at) continue;
      next = i;
      ++found;
    }
    if (found != 1) return false;
    std::swap(ends[done], ends[next]);
    at = ends[done].first == at ? ends[done].second : ends[done].first;
  }
  return at == ends[0].first;
}

VertexSheets::VertexSheets(std::span<const StarTriangle> star, const RankedPoints& points)
    : star_(star) {
  std::vector<Spoke> spokes;
  spokes.reserve(2 * star.size());
  for (std::uint32_t t = 0; t < star.size(); ++t) {
    spokes.push_back({star[t].low, t});
    spokes.push_back({star[t].high, t});
  }
  std::sort(spokes.begin(), spokes.end(), [](const Spoke& a, const Spoke& b) {
    return std::tie(a.other, a.triangle) < std::tie(b.other, b.triangle);
  });
  for (std::size_t begin = 0; begin < spokes.size();) {
    std::size_t end = begin + 1;
    while (end < spokes.size() && spokes[end].other == spokes[begin].other) ++end;
    find_wedges(std::span(spokes).subspan(begin, end - begin), points);
    begin = end;
  }
  number_sheets();
}

void VertexSheets::find_wedges(std::span<const Spoke> spokes, const RankedPoints& points) {
  if (spokes.size() == 2) {
    plain_.push_back({spokes[0].triangle, spokes[1].triangle});
    return;
  }
  const ShortRank other = spokes[0].other;
  std::vector<WedgeSide> sides;
  for (const Spoke& spoke : spokes) {
    const StarTriangle& t = star_[spoke.triangle];
    const bool rises = (t.is_outward != 0) == (other == t.low);
    const ShortRank third = t.other_than(other);
    sides.push_back({points.at(third), third, rises, spoke.triangle});
  }
  const std::array<Point3, 2> edge{points.at(star_[0].vertex), points.at(other)};
  multiple_.push_back({other, inside_wedges(edge, sides, points.predicates())});
  if (2 * multiple_.back().wedges.size() != spokes.size()) fail_open();
}

void VertexSheets::number_sheets() {
  Joined joined(star_.size());
  for (const Wedge& wedge : plain_) joined.join(wedge);
  for (const MultipleEdge& edge : multiple_) {
    for (const Wedge& wedge : edge.wedges) joined.join(wedge);
  }
  count_ = 0;
  sheets_.resize(star_.size());
  for (std::uint32_t t = 0; t < star_.size(); ++t) {
    const std::uint32_t root = joined.root(t);
    sheets_[t] = root == t ? count_++ : sheets_[root];
  }
}

/// A wedge's second triangle rises along the edge from this vertex to the other.
ShortRank VertexSheets::third_of(const Wedge& wedge, ShortRank other) const {
  return star_[star_[0].vertex < other ? wedge[1] : wedge[0]].other_than(other);
}

std::vector<SheetTouch> VertexSheets::touches() const {
  std::vector<SheetTouch> touches;
  for (const MultipleEdge& edge : multiple_) {
    for (const Wedge& wedge : edge.wedges) {
      const std::uint32_t sheet = sheets_[wedge[0]];
      const auto wedges =
          std::count_if(edge.wedges.begin(), edge.wedges.end(),
                        [&](const Wedge& other) { return sheets_[other[0]] == sheet; });
      if (wedges < 2) continue;
      touches.push_back({edge.other, star_[0].vertex, third_of(wedge, edge.other), sheet});
    }
  }
  return touches;
}

void VertexSheets::part(std::span<const SheetTouch> from_far_ends) {
  if (from_far_ends.empty()) return;
  for (MultipleEdge& edge : multiple_) part(edge, from_far_ends);
  number_sheets();
}

void VertexSheets::part(MultipleEdge& edge, std::span<const SheetTouch> from_far_ends) const {
  std::vector<TwoSheets> known;
  for (std::uint32_t i = 0; i < edge.wedges.size(); ++i) {
    const Wedge& wedge = edge.wedges[i];
    const SheetTouch wanted{star_[0].vertex, edge.other, third_of(wedge, edge.other), 0};
    const auto touch = std::lower_bound(from_far_ends.begin(), from_far_ends.end(), wanted);
    if (touch == from_far_ends.end() || touch->vertex != wanted.vertex ||
        touch->other != wanted.other || touch->third != wanted.third) {
      continue;
    }
    known.push_back({sheets_[wedge[0]], touch->sheet, i});
  }
  std::sort(known.begin(), known.end());
  for (std::size_t begin = 0; begin < known.size();) {
    std::size_t end = begin + 1;
    while (end < known.size() && known[end].has_sheets_of(known[begin])) ++end;
    turn_outside(std::span(known).subspan(begin, end - begin), edge.wedges);
    edge.is_turned = true;
    begin = end;
  }
}

std::vector<TurnedPair> VertexSheets::turned_pairs() const {
  std::vector<TurnedPair> pairs;
  for (const MultipleEdge& edge : multiple_) {
    if (!edge.is_turned) continue;
    const auto [low, high] = std::minmax(star_[0].vertex, edge.other);
    for (const Wedge& wedge : edge.wedges) {
      const ShortRank a = star_[wedge[0]].other_than(edge.other);
      const ShortRank b = star_[wedge[1]].other_than(edge.other);
      const bool is_low = star_[0].vertex < edge.other;
      pairs.push_back({low, high, is_low ? std::array{a, b} : std::array{b, a}});
    }
  }
  return pairs;
}

std::uint64_t VertexSheets::multiple_edges() const {
  return static_cast<std::uint64_t>(
      std::count_if(multiple_.begin(), multiple_.end(),
                    [this](const MultipleEdge& edge) { return edge.other > star_[0].vertex; }));
}

std::uint64_t VertexSheets::added_edges() const {
  std::uint64_t added = 0;
  for (const MultipleEdge& edge : multiple_) {
    if (edge.other > star_[0].vertex) added += edge.wedges.size() - 1;
  }
  return added;
}

}  // namespace stream_recon
