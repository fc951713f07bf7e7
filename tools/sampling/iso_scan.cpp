#include "tools/sampling/iso_scan.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace stream_recon {
namespace {

constexpr double kLeastFraction = 0x1p-40;

}  // namespace

IsoScan::IsoScan(Grid& grid, double value, GridPointConsumer consume)
    : grid_(grid),
      value_(value),
      consume_(std::move(consume)),
      width_(grid.size()[0]),
      height_(grid.size()[1]),
      depth_(grid.size()[2]) {
  for (std::vector<double>* slice : {&before_, &here_, &after_}) slice->resize(width_ * height_);
}

bool IsoScan::step() {
  if (k_ == depth_) return false;
  if (k_ == 0) grid_.read_slice(0, after_);
  before_.swap(here_);
  here_.swap(after_);
  if (k_ + 1 < depth_) grid_.read_slice(k_ + 1, after_);
  for (std::size_t j = 0; j < height_; ++j)
    for (std::size_t i = 0; i < width_; ++i) visit(i, j);
  ++k_;
  return true;
}

void IsoScan::visit(std::size_t i, std::size_t j) {
  const std::size_t at = j * width_ + i;
  const double a = here_[at];
  if (!std::isfinite(a)) return;
  const Point3 cell{static_cast<double>(i), static_cast<double>(j), static_cast<double>(k_)};
  if (a == value_ && has_lower_neighbor(i, j)) {
    consume_({cell, {}});
    ++points_;
  }
  if (i + 1 < width_) cross(a, here_[at + 1], {1, 0, 0}, cell);
  if (j + 1 < height_) cross(a, here_[at + width_], {0, 1, 0}, cell);
  if (k_ + 1 < depth_) cross(a, after_[at], {0, 0, 1}, cell);
}

bool IsoScan::is_lower(double neighbor) const {
  return std::isfinite(neighbor) && neighbor < value_;
}

bool IsoScan::has_lower_neighbor(std::size_t i, std::size_t j) const {
  const std::size_t at = j * width_ + i;
  return (i > 0 && is_lower(here_[at - 1])) || (i + 1 < width_ && is_lower(here_[at + 1])) ||
         (j > 0 && is_lower(here_[at - width_])) ||
         (j + 1 < height_ && is_lower(here_[at + width_])) || (k_ > 0 && is_lower(before_[at])) ||
         (k_ + 1 < depth_ && is_lower(after_[at]));
}

// Ends that have the value exactly belong to visit().
void IsoScan::cross(double a, double b, const Point3& axis, const Point3& cell) {
  if (!std::isfinite(b) || !((a < value_ && b > value_) || (a > value_ && b < value_))) return;
  const double t = std::clamp(fraction(a, b), kLeastFraction, 1 - kLeastFraction);
  consume_({cell, {t * axis.x, t * axis.y, t * axis.z}});
  ++points_;
}

// Halves keep the differences finite whatever the cells are.
double IsoScan::fraction(double a, double b) const {
  return (value_ / 2 - a / 2) / (b / 2 - a / 2);
}

}  // namespace stream_recon
