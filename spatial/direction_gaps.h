// The gaps between directions in a plane, as directions are added.
//
// Guarantees: counts the pairs of consecutive directions, counterclockwise, that are more than
// 150 degrees apart; one direction alone is 360 from itself. At most two gaps can be so wide, so
// that it is enough to remember the directions that have none close behind them. Thread rule: one
// owner. Cost of a direction: about 1 ns for each one before.
#pragma once

#include <array>
#include <cstddef>

namespace stream_recon {

class DirectionGaps {
 public:
  static constexpr std::size_t kMost = 32;

  /// The components of a direction, of unit length but for rounding.
  /// \pre fewer than kMost directions so far
  void add(double u, double w) {
    std::size_t left = 0;
    for (std::size_t i = 0; i < open_count_; ++i) {
      const std::size_t at = open_[i];
      open_[left] = at;
      left += is_ahead(cross(u_[at], w_[at], u, w) > 0, at, u, w) ? 0 : 1;
    }
    open_count_ = left;
    // Of equal directions the later is the one in front.
    bool has_one_behind = false;
    for (std::size_t i = 0; i < count_; ++i) {
      has_one_behind |= is_ahead(cross(u, w, u_[i], w_[i]) >= 0, i, u, w);
    }
    if (!has_one_behind) open_[open_count_++] = count_;
    u_[count_] = u;
    w_[count_] = w;
    ++count_;
  }

  std::size_t count() const { return count_; }
  std::size_t wide() const { return open_count_; }

 private:
  static constexpr double kCosine = -0.86602540378443865;  // of 150 degrees

  static double cross(double au, double aw, double bu, double bw) { return au * bw - aw * bu; }
  /// On that side, and not too far. No branch: it would be taken at random.
  bool is_ahead(bool is_on_side, std::size_t i, double u, double w) const {
    return (is_on_side & (u_[i] * u + w_[i] * w >= kCosine)) != 0;
  }

  std::array<double, kMost> u_;
  std::array<double, kMost> w_;
  std::size_t count_ = 0;
  std::array<std::size_t, kMost> open_;  ///< places of those with a wide gap behind them
  std::size_t open_count_ = 0;
};

}  // namespace stream_recon
