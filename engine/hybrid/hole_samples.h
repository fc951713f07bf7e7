// Which holes each sample is a corner of.
//
// Thread rule: const once finished. Memory, from the budget: 8 bytes a sample of a hole, and one
// bit a sample of the cloud. Cost of a look-up: 100 ns where the sample is of a hole, else 5 ns.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/budget.h"
#include "engine/hybrid/hole_records.h"
#include "engine/power/sample_choice.h"

namespace stream_recon {

class HoleSamples {
 public:
  /// \throw BudgetError
  HoleSamples(std::uint64_t samples, MemoryBudget& budget)
      : memory_(budget.reserve(SampleChoice::memory(samples), "the samples of holes")),
        choice_(samples) {}

  /// \throw BudgetError
  void add(std::span<const std::uint32_t> ranks, std::uint32_t hole) {
    if (holes_.capacity() - holes_.size() < ranks.size()) grow(ranks.size());
    for (const std::uint32_t rank : ranks) {
      holes_.push_back({rank, hole});
      choice_.choose(rank);
    }
  }
  /// All are added.
  void finish() { std::sort(holes_.begin(), holes_.end()); }

  bool empty() const { return holes_.empty(); }
  const SampleChoice& choice() const { return choice_; }
  /// Its holes, ascending.
  std::span<const HoleSample> of(std::uint32_t rank) const {
    if (!choice_.has(rank)) return {};
    const auto first = std::lower_bound(holes_.begin(), holes_.end(), HoleSample{rank, 0});
    auto end = first;
    while (end != holes_.end() && end->rank == rank) ++end;
    return {first, end};
  }

 private:
  /// By half, while the old ones are still there.
  void grow(std::size_t more) {
    const std::size_t size = std::max(holes_.size() + more, holes_.size() * 3 / 2);
    memory_.resize(memory_.bytes() + size * sizeof(HoleSample));
    const std::size_t before = holes_.capacity();
    holes_.reserve(size);
    memory_.resize(memory_.bytes() - before * sizeof(HoleSample));
  }

  Reservation memory_;
  SampleChoice choice_;
  std::vector<HoleSample> holes_;
};

}  // namespace stream_recon
