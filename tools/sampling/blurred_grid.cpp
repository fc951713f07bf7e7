#include "tools/sampling/blurred_grid.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace stream_recon {
namespace {

std::vector<float> gaussian(double sigma, std::size_t radius) {
  std::vector<double> weights;
  double sum = 0;
  for (std::size_t t = 0; t <= 2 * radius; ++t) {
    const double x = (static_cast<double>(t) - static_cast<double>(radius)) / sigma;
    weights.push_back(std::exp(-x * x / 2));
    sum += weights.back();
  }
  std::vector<float> kernel;
  for (const double weight : weights) kernel.push_back(static_cast<float>(weight / sum));
  return kernel;
}

/// out += weight * in
void add_scaled(float weight, std::span<const float> in, std::span<float> out) {
  for (std::size_t at = 0; at < out.size(); ++at) out[at] += weight * in[at];
}

}  // namespace

std::size_t blur_radius(double sigma) {
  return static_cast<std::size_t>(std::ceil(3 * sigma));
}

BlurredGrid::BlurredGrid(Grid& source, double sigma, BeyondEdge beyond)
    : source_(source),
      beyond_(beyond),
      radius_(blur_radius(sigma)),
      kernel_(gaussian(sigma, radius_)),
      planes_(2 * radius_ + 1),
      slice_(source.slice_cells()),
      rows_(source.slice_cells()) {
  assert(sigma > 0);
}

BlurredGrid::Plane& BlurredGrid::plane(std::size_t k) {
  Plane& plane = planes_[k % planes_.size()];
  if (plane.k != k) fill(plane, k);
  return plane;
}

void BlurredGrid::fill(Plane& plane, std::size_t k) {
  plane.k = static_cast<std::size_t>(-1);
  source_.read_slice(k, slice_);
  plane.sum.assign(slice_.begin(), slice_.end());
  if (beyond_ == BeyondEdge::kIgnored) {
    plane.weight.assign(slice_.size(), 1);
    plane.known.assign(slice_.size(), true);
    for (std::size_t at = 0; at < slice_.size(); ++at) {
      if (std::isfinite(slice_[at])) continue;
      plane.sum[at] = plane.weight[at] = 0;
      plane.known[at] = false;
    }
    blur_in_plane(plane.weight);
  }
  blur_in_plane(plane.sum);
  plane.k = k;
}

void BlurredGrid::blur_in_plane(std::vector<float>& cells) {
  const std::size_t width = size()[0];
  const std::size_t height = size()[1];
  std::vector<float> padded(width + 2 * radius_);
  for (std::size_t j = 0; j < height; ++j) {
    std::copy_n(&cells[j * width], width, &padded[radius_]);
    const auto row = std::span(rows_).subspan(j * width, width);
    std::fill(row.begin(), row.end(), 0.0F);
    for (std::size_t t = 0; t < kernel_.size(); ++t) {
      add_scaled(kernel_[t], std::span(padded).subspan(t, width), row);
    }
  }
  std::fill(cells.begin(), cells.end(), 0.0F);
  for (std::size_t j = 0; j < height; ++j) {
    const std::size_t first = j < radius_ ? radius_ - j : 0;
    const std::size_t last = std::min(kernel_.size(), height - j + radius_);
    for (std::size_t t = first; t < last; ++t) {
      add_scaled(kernel_[t], std::span(rows_).subspan((j + t - radius_) * width, width),
                 std::span(cells).subspan(j * width, width));
    }
  }
}

void BlurredGrid::add_planes(std::size_t k, std::vector<float> Plane::*part,
                             std::vector<float>& total) {
  total.assign(slice_.size(), 0.0F);
  const std::size_t first = k < radius_ ? radius_ - k : 0;
  const std::size_t last = std::min(kernel_.size(), size()[2] - k + radius_);
  for (std::size_t t = first; t < last; ++t) {
    add_scaled(kernel_[t], plane(k + t - radius_).*part, total);
  }
}

void BlurredGrid::read_slice(std::size_t k, std::span<double> out) {
  add_planes(k, &Plane::sum, total_);
  std::copy(total_.begin(), total_.end(), out.begin());
  if (beyond_ == BeyondEdge::kZero) return;
  add_planes(k, &Plane::weight, total_weight_);
  const std::vector<bool>& known = plane(k).known;
  for (std::size_t at = 0; at < out.size(); ++at) {
    out[at] = known[at] ? out[at] / static_cast<double>(total_weight_[at])
                        : std::numeric_limits<double>::quiet_NaN();
  }
}

}  // namespace stream_recon
