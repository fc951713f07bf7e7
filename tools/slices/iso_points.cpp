#include "tools/slices/iso_points.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace stream_recon {
namespace {

constexpr double kLeastFraction = 0x1p-40;

class IsoScan {
 public:
  IsoScan(Volume& volume, double value, const PointConsumer& consume)
      : volume_(volume), geometry_(volume.geometry()), value_(value), consume_(consume) {
    width_ = geometry_.size[0];
    height_ = geometry_.size[1];
    depth_ = geometry_.size[2];
    for (std::vector<double>* slice : {&before_, &here_, &after_}) slice->resize(width_ * height_);
  }

  std::uint64_t run() {
    if (depth_ > 0) volume_.read_slice(0, after_);
    for (k_ = 0; k_ < depth_; ++k_) {
      before_.swap(here_);
      here_.swap(after_);
      if (k_ + 1 < depth_) volume_.read_slice(k_ + 1, after_);
      for (std::size_t j = 0; j < height_; ++j)
        for (std::size_t i = 0; i < width_; ++i) visit(i, j);
    }
    return count_;
  }

 private:
  void visit(std::size_t i, std::size_t j) {
    const std::size_t at = j * width_ + i;
    const double a = here_[at];
    if (!std::isfinite(a)) return;
    if (a == value_ && has_lower_neighbor(i, j)) deliver(0, 0, 0, i, j);
    if (i + 1 < width_) cross(a, here_[at + 1], {1, 0, 0}, i, j);
    if (j + 1 < height_) cross(a, here_[at + width_], {0, 1, 0}, i, j);
    if (k_ + 1 < depth_) cross(a, after_[at], {0, 0, 1}, i, j);
  }

  bool is_lower(double neighbor) const { return std::isfinite(neighbor) && neighbor < value_; }

  bool has_lower_neighbor(std::size_t i, std::size_t j) const {
    const std::size_t at = j * width_ + i;
    return (i > 0 && is_lower(here_[at - 1])) || (i + 1 < width_ && is_lower(here_[at + 1])) ||
           (j > 0 && is_lower(here_[at - width_])) ||
           (j + 1 < height_ && is_lower(here_[at + width_])) || (k_ > 0 && is_lower(before_[at])) ||
           (k_ + 1 < depth_ && is_lower(after_[at]));
  }

  // Ends that have the value exactly belong to visit().
  void cross(double a, double b, const Point3& axis, std::size_t i, std::size_t j) {
    if (!std::isfinite(b) || !((a < value_ && b > value_) || (a > value_ && b < value_))) return;
    const double t = std::clamp(fraction(a, b), kLeastFraction, 1 - kLeastFraction);
    deliver(t * axis.x, t * axis.y, t * axis.z, i, j);
  }

  // Halves keep the differences finite whatever the voxels are.
  double fraction(double a, double b) const { return (value_ / 2 - a / 2) / (b / 2 - a / 2); }

  void deliver(double di, double dj, double dk, std::size_t i, std::size_t j) {
    consume_(geometry_.position(static_cast<double>(i) + di, static_cast<double>(j) + dj,
                                static_cast<double>(k_) + dk));
    ++count_;
  }

  Volume& volume_;
  const VolumeGeometry& geometry_;
  double value_;
  const PointConsumer& consume_;
  std::size_t width_, height_, depth_;
  std::vector<double> before_, here_, after_;
  std::size_t k_ = 0;
  std::uint64_t count_ = 0;
};

}  // namespace

std::uint64_t scan_iso_points(Volume& volume, double value, const PointConsumer& consume) {
  return IsoScan(volume, value, consume).run();
}

}  // namespace stream_recon
