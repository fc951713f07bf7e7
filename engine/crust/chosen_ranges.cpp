#include "engine/crust/chosen_ranges.h"

#include <algorithm>
#include <span>

#include "engine/poles/pole_store.h"

namespace stream_recon {
namespace {

using namespace index_layout;

constexpr std::size_t kBatch = 1 << 12;
/// A window of its own, its guests above all, costs about as much as so many samples.
constexpr std::uint64_t kWorthAWindow = 4096;

}  // namespace

std::vector<OwnedRange> chosen_ranges(const SampleChoice& choice, const CloudIndex& index,
                                      const StageContext& context) {
  const std::uint64_t leaves = quotient_up(index.point_count, kLeafPoints);
  const Reservation memory = context.budget.reserve(leaves / 8 + 64, "the poles at holes");
  std::vector<bool> is_chosen(leaves);
  const PoleFile file(context.scratch.open(kPoleStore));
  PoleReader reader(file, context.budget);
  std::vector<Pole> batch(kBatch);
  while (const std::size_t count = reader.read(batch)) {
    context.stop.check();
    for (const Pole& pole : std::span<const Pole>(batch).first(count)) {
      if (pole.is_inside == 0 || !choice.has_corner_of(pole.tetrahedron)) continue;
      is_chosen[pole.lowest_rank() / kLeafPoints] = true;
    }
  }
  std::vector<OwnedRange> ranges;
  for (std::uint64_t leaf = 0; leaf < leaves; ++leaf) {
    if (!is_chosen[leaf]) continue;
    const PointRank first = leaf * kLeafPoints;
    const PointRank end = std::min(first + kLeafPoints, index.point_count);
    if (!ranges.empty() && first - ranges.back().end() <= kWorthAWindow) {
      ranges.back().count = end - ranges.back().first;
    } else {
      ranges.push_back({first, end - first});
    }
  }
  return ranges;
}

}  // namespace stream_recon
