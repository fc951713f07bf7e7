#include "engine/hybrid/unique_places.h"

#include <algorithm>
#include <tuple>

namespace stream_recon {
namespace {

struct Pair {
  double squared_distance = 0;
  std::uint32_t sample = 0;
  std::uint32_t place = 0;

  friend bool operator<(const Pair& a, const Pair& b) {
    return std::tie(a.squared_distance, a.sample, a.place) <
           std::tie(b.squared_distance, b.sample, b.place);
  }
};

}  // namespace

std::vector<std::uint32_t> unique_places(std::span<const Point3> samples, const Neighbors& places,
                                         const MayBePlace& may_be,
                                         const UniquePlacesOptions& options) {
  std::vector<Pair> pairs;
  for (std::uint32_t sample = 0; sample < samples.size(); ++sample) {
    for (const Neighbor& near : places.nearest(samples[sample], options.nearest)) {
      if (may_be(sample, near.index)) pairs.push_back({near.squared_distance, sample, near.index});
    }
  }
  std::sort(pairs.begin(), pairs.end());
  std::vector<std::uint32_t> result(samples.size(), kNoPlace);
  std::vector<bool> is_taken(places.count());
  for (const Pair& pair : pairs) {
    if (result[pair.sample] != kNoPlace || is_taken[pair.place]) continue;
    result[pair.sample] = pair.place;
    is_taken[pair.place] = true;
  }
  return result;
}

}  // namespace stream_recon
