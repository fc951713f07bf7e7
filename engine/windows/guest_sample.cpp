#include "engine/windows/guest_sample.h"

#include <algorithm>
#include <limits>

#include "engine/windows/owned_cover.h"

namespace stream_recon {
namespace {

using namespace index_layout;

/// Guests to begin with, for each owned point.
constexpr std::uint64_t kMostGuests = 2;

double squared(double value) {
  return value * value;
}

double gap(float low_a, float high_a, float low_b, float high_b) {
  return std::max(0.0, std::max(double{low_a} - high_b, double{low_b} - high_a));
}

double squared_distance(const NodeBounds& a, const NodeBounds& b) {
  double sum = 0;
  for (int i = 0; i < 3; ++i) sum += squared(gap(a.low[i], a.high[i], b.low[i], b.high[i]));
  return sum;
}

class Sampling {
 public:
  Sampling(const CloudIndex& index, IndexReader& reader, const OwnedRange& owned,
           const GuestSampleOptions& options)
      : index_(index),
        reader_(reader),
        owned_(owned),
        options_(options),
        owned_boxes_(cover_owned(index, reader, owned)) {}

  GuestSample run() {
    const auto level = static_cast<std::uint32_t>(index_.top.size() - 1);
    visit_top(level, 0);
    return std::move(sample_);
  }

 private:
  double squared_distance_to_owned(const NodeBounds& bounds) const {
    double least = std::numeric_limits<double>::infinity();
    for (const NodeBounds& box : owned_boxes_) {
      least = std::min(least, squared_distance(bounds, box));
    }
    return least;
  }

  enum class Choice { kNothing, kOne, kDescend, kWhole };

  Choice choose(const NodeBounds& bounds, const LeafRange& leaves) const {
    if (bounds.empty()) return Choice::kNothing;
    if (leaves.begin * kLeafPoints >= owned_.first && leaves.end * kLeafPoints <= owned_.end()) {
      return Choice::kNothing;
    }
    const double diagonal = squared_diagonal(bounds);
    const double distance = squared_distance_to_owned(bounds);
    if (distance > squared(options_.far) * diagonal) return Choice::kOne;
    if (leaves.end - leaves.begin > 1) return Choice::kDescend;
    return distance <= squared(options_.halo) * diagonal ? Choice::kWhole : Choice::kOne;
  }

  void visit_top(std::uint32_t level, std::uint64_t node) {
    const LeafRange leaves = leaves_below_top(level, node);
    switch (choose(index_.top[level][node], leaves)) {
      case Choice::kOne:
        sample_.singles.push_back(leaves.begin * kLeafPoints);
        break;
      case Choice::kDescend:
        if (level == 0) {
          visit_children(node, 0);
        } else {
          const std::uint64_t end =
              std::min<std::uint64_t>(kFanout * (node + 1), index_.top[level - 1].size());
          for (std::uint64_t c = kFanout * node; c < end; ++c) visit_top(level - 1, c);
        }
        break;
      case Choice::kNothing:
      case Choice::kWhole:
        break;
    }
  }

  void visit_children(std::uint64_t page, std::uint32_t node) {
    for (std::uint32_t child = 4 * node + 1; child <= 4 * node + 4; ++child) {
      const LeafRange leaves = leaves_below(page, child);
      switch (choose(reader_.nodes(page).nodes[child], leaves)) {
        case Choice::kOne:
          sample_.singles.push_back(leaves.begin * kLeafPoints);
          break;
        case Choice::kDescend:
          visit_children(page, child);
          break;
        case Choice::kWhole:
          sample_.leaves.push_back(leaves.begin);
          break;
        case Choice::kNothing:
          break;
      }
    }
  }

  const CloudIndex& index_;
  IndexReader& reader_;
  const OwnedRange& owned_;
  const GuestSampleOptions& options_;
  std::vector<NodeBounds> owned_boxes_;
  GuestSample sample_;
};

}  // namespace

GuestSample sample_guests(const CloudIndex& index, IndexReader& reader, const OwnedRange& owned,
                          const GuestSampleOptions& options) {
  GuestSample sample = Sampling(index, reader, owned, options).run();
  if (sample.leaves.size() * kLeafPoints <= kMostGuests * owned.count + kPagePoints) return sample;
  // Too much of the cloud is near: what is needed of it, the conflicts will tell.
  GuestSampleOptions coarse = options;
  coarse.halo = 0;
  coarse.far = std::min(options.far, 1.0);
  sample = Sampling(index, reader, owned, coarse).run();
  for (const LeafNumber leaf : sample.leaves) sample.singles.push_back(leaf * kLeafPoints);
  sample.leaves.clear();
  return sample;
}

}  // namespace stream_recon
