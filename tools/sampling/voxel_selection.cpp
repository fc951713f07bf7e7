#include "tools/sampling/voxel_selection.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace stream_recon {
namespace {

template <typename Belongs>
void mark_each(std::span<const double> voxels, std::span<std::uint8_t> inside, Belongs belongs) {
  for (std::size_t at = 0; at < voxels.size(); ++at) {
    inside[at] = belongs(voxels[at]) && std::isfinite(voxels[at]) ? 1 : 0;
  }
}

}  // namespace

VoxelSelection VoxelSelection::of_labels(std::vector<double> labels) {
  assert(!labels.empty());
  std::sort(labels.begin(), labels.end());
  labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
  return {Kind::kLabels, std::move(labels)};
}

void VoxelSelection::mark(std::span<const double> voxels, std::span<std::uint8_t> inside) const {
  assert(voxels.size() == inside.size());
  switch (kind_) {
    case Kind::kAbove:
      return mark_each(voxels, inside, [v = values_[0]](double x) { return x > v; });
    case Kind::kAtLeast:
      return mark_each(voxels, inside, [v = values_[0]](double x) { return x >= v; });
    case Kind::kNotZero:
      return mark_each(voxels, inside, [](double x) { return x != 0; });
    case Kind::kLabels:
      break;
  }
  if (values_.size() == 1) {
    return mark_each(voxels, inside, [v = values_[0]](double x) { return x == v; });
  }
  mark_each(voxels, inside,
            [this](double x) { return std::binary_search(values_.begin(), values_.end(), x); });
}

std::string VoxelSelection::description() const {
  switch (kind_) {
    case Kind::kAbove:
      return fmt::format("above {}", values_[0]);
    case Kind::kAtLeast:
      return fmt::format("at least {}", values_[0]);
    case Kind::kNotZero:
      return "any label";
    case Kind::kLabels:
      break;
  }
  return fmt::format("label{} {}", values_.size() > 1 ? "s" : "", fmt::join(values_, ","));
}

}  // namespace stream_recon
