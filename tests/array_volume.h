// A volume in memory, for tests of what is done with volumes.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "tools/slices/volume.h"

namespace stream_recon {

class ArrayVolume : public Volume {
 public:
  ArrayVolume(std::array<std::size_t, 3> size, std::vector<double> values)
      : values_(std::move(values)) {
    geometry_.size = size;
    geometry_.step = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  }

  /// Voxels from a function of i, j, k.
  template <typename Function>
  static ArrayVolume made(std::array<std::size_t, 3> size, Function value) {
    std::vector<double> values;
    for (std::size_t k = 0; k < size[2]; ++k)
      for (std::size_t j = 0; j < size[1]; ++j)
        for (std::size_t i = 0; i < size[0]; ++i) values.push_back(value(i, j, k));
    return {size, std::move(values)};
  }

  VolumeGeometry& change() { return geometry_; }
  const VolumeGeometry& geometry() const override { return geometry_; }
  void read_slice(std::size_t k, std::span<double> out) override {
    std::copy_n(values_.begin() + static_cast<std::ptrdiff_t>(k * out.size()), out.size(),
                out.begin());
  }

  double at(std::size_t i, std::size_t j, std::size_t k) const {
    return values_[(k * geometry_.size[1] + j) * geometry_.size[0] + i];
  }
  /// As at(), `beyond` outside the volume.
  double at_or(const std::array<long, 3>& cell, double beyond) const {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (cell[axis] < 0 || cell[axis] >= static_cast<long>(geometry_.size[axis])) return beyond;
    }
    return at(static_cast<std::size_t>(cell[0]), static_cast<std::size_t>(cell[1]),
              static_cast<std::size_t>(cell[2]));
  }

 private:
  std::vector<double> values_;
  VolumeGeometry geometry_;
};

}  // namespace stream_recon
