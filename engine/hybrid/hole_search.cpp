#include "engine/hybrid/hole_search.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "engine/each_record.h"
#include "engine/hybrid/hole_records.h"
#include "engine/labels/facet_labels.h"
#include "engine/order/external_sort.h"
#include "engine/order/point_store.h"
#include "engine/surface/facet_record.h"
#include "io/error.h"

namespace stream_recon {
namespace {

/// Fills as they are found, each at the position of its number.
constexpr const char* kNumberedFills = "hole_fills_by_number";

struct FillEdge {
  std::uint32_t low;
  std::uint32_t high;
  std::uint32_t fill;

  bool is_edge_of(const FillEdge& other) const { return low == other.low && high == other.high; }
  friend bool operator<(const FillEdge& a, const FillEdge& b) {
    return std::tie(a.low, a.high, a.fill) < std::tie(b.low, b.high, b.fill);
  }
};

/// Sets of fills, each known by its lowest.
class FillSets {
 public:
  FillSets(std::uint64_t count, MemoryBudget& budget)
      : memory_(budget.reserve(count * sizeof(std::uint32_t), "the holes of the gamma shape")),
        parents_(count) {
    std::iota(parents_.begin(), parents_.end(), 0);
  }

  std::uint32_t lowest(std::uint32_t fill) {
    while (parents_[fill] != fill) fill = parents_[fill] = parents_[parents_[fill]];
    return fill;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t one = lowest(a);
    const std::uint32_t two = lowest(b);
    parents_[std::max(one, two)] = std::min(one, two);
  }

 private:
  Reservation memory_;
  std::vector<std::uint32_t> parents_;
};

HoleFill fill_of(const FacetRecord& facet) {
  HoleFill fill{.ranks = ranks_of(facet)};
  fill.delta = facet.delta;
  fill.closure = facet.closure;
  fill.facing = static_cast<std::int8_t>(facet.facing);
  return fill;
}

class HoleSearch {
 public:
  explicit HoleSearch(const StageContext& context) : context_(context) {}

  HoleCounts run() {
    FillSets sets = join_fills();
    {
      ExternalSort<HoleSample> samples(context_, sort_options<HoleSample>("samples of holes"));
      store_fills(sets, samples);
      context_.scratch.remove(kNumberedFills);
      store_points(samples);
    }
    return counts_;
  }

 private:
  /// Two sorts may be there at a time.
  template <class Record>
  ExternalSortOptions sort_options(const char* name) const {
    const std::uint64_t share = context_.budget.available() * 2 / 5;
    return {name, std::max(share, ExternalSort<Record>::least_memory())};
  }

  void gather(ExternalSort<FacetRecord>& facets) const {
    for (const std::string& name : context_.scratch.names()) {
      if (!export_first_rank(name, kFillsPrefix)) continue;
      for_each_record<FacetRecord>(context_, name,
                                   [&](const FacetRecord& facet) { facets.add(facet); });
      context_.scratch.remove(name);
    }
  }

  FillSets join_fills() {
    ExternalSort<FillEdge> edges(context_, sort_options<FillEdge>("edges of holes"));
    {
      ExternalSort<FacetRecord> facets(context_, sort_options<FacetRecord>("fills of holes"));
      gather(facets);
      number_fills(facets, edges);
    }
    FillSets sets(counts_.fills, context_.budget);
    std::optional<FillEdge> last;
    edges.for_each([&](const FillEdge& edge) {
      if (last && last->is_edge_of(edge)) sets.join(last->fill, edge.fill);
      last = edge;
    });
    return sets;
  }

  void number_fills(ExternalSort<FacetRecord>& facets, ExternalSort<FillEdge>& edges) {
    if (facets.count() > std::numeric_limits<std::uint32_t>::max()) {
      throw InputError("the gamma shape lacks more than 4294967295 facets; split the cloud");
    }
    auto fills = create_records<HoleFill>(context_.scratch, kNumberedFills, kHoleBlock);
    facets.for_each([&](const FacetRecord& facet) {
      const HoleFill fill = fill_of(facet);
      const auto number = static_cast<std::uint32_t>(counts_.fills++);
      edges.add({fill.ranks[0], fill.ranks[1], number});
      edges.add({fill.ranks[0], fill.ranks[2], number});
      edges.add({fill.ranks[1], fill.ranks[2], number});
      fills.append(fill);
    });
    fills.finish();
  }

  void store_fills(FillSets& sets, ExternalSort<HoleSample>& samples) {
    ExternalSort<HoleFill> sorted(context_, sort_options<HoleFill>("holes"));
    std::uint32_t number = 0;
    for_each_record<HoleFill>(context_, kNumberedFills, [&](HoleFill fill) {
      fill.hole = sets.lowest(number++);
      sorted.add(fill);
    });
    auto fills = create_records<HoleFill>(context_.scratch, kHoleFills, kHoleBlock);
    std::optional<std::uint32_t> last;
    sorted.for_each([&](HoleFill fill) {
      if (last != fill.hole) ++counts_.holes;
      last = fill.hole;
      fill.hole = static_cast<std::uint32_t>(counts_.holes - 1);
      for (const std::uint32_t rank : fill.ranks) samples.add({rank, fill.hole});
      fills.append(fill);
    });
    fills.finish();
  }

  void store_points(ExternalSort<HoleSample>& samples) const {
    PointStoreReader store(context_.scratch, kPointStore);
    ExternalSort<HolePoint> sorted(context_, sort_options<HolePoint>("points of holes"));
    std::optional<HoleSample> last;
    StoredPoint stored;
    samples.for_each([&](const HoleSample& sample) {
      if (last == sample) return;
      if (!last || last->rank != sample.rank) store.read_at(sample.rank, std::span(&stored, 1));
      last = sample;
      sorted.add({sample.hole, sample.rank, stored.point});
    });
    auto points = create_records<HolePoint>(context_.scratch, kHolePoints, kHoleBlock);
    sorted.for_each([&](const HolePoint& point) { points.append(point); });
    points.finish();
  }

  const StageContext& context_;
  HoleCounts counts_;
};

}  // namespace

HoleCounts find_holes(const StageContext& context) {
  return HoleSearch(context).run();
}

}  // namespace stream_recon
