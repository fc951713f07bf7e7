// Samples at which the crust is asked for, where that is not all of them.
//
// Thread rule: const once made. Memory: one bit a sample of the cloud.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/labels/evidence_records.h"

namespace stream_recon {

class SampleChoice {
 public:
  static constexpr std::uint64_t memory(std::uint64_t samples) { return samples / 8 + 64; }

  explicit SampleChoice(std::uint64_t samples) : is_chosen_(samples) {}

  void choose(std::uint32_t rank) { is_chosen_[rank] = true; }
  bool has(std::uint32_t rank) const { return is_chosen_[rank]; }
  /// Whether the ball of the tetrahedron touches one of them.
  bool has_corner_of(const NodeKey& tetrahedron) const {
    const auto& ranks = tetrahedron.ranks;
    return has(ranks[0]) || has(ranks[1]) || has(ranks[2]) || has(ranks[3]);
  }

 private:
  std::vector<bool> is_chosen_;
};

}  // namespace stream_recon
