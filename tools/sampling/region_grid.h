// The part of a volume that is sampled: a box, and of it every n-th voxel.
//
// Memory: one slice of the volume. Thread rule: one reader.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tools/sampling/grid.h"
#include "tools/slices/volume.h"

namespace stream_recon {

/// A box of voxels, along each axis from the first up to, but without, the second; an end that is
/// not given is the volume's.
using RegionOfInterest =
    std::array<std::pair<std::optional<std::size_t>, std::optional<std::size_t>>, 3>;

/// Reads "10:200,:,5:40". \throw std::invalid_argument
RegionOfInterest parse_region(const std::string& text);

/// \throw std::invalid_argument no voxel of a volume of that size lies in it
GridBox box_of(const RegionOfInterest& region, const GridSize& size);

class RegionGrid : public Grid {
 public:
  /// \pre `box` lies in the volume and is not empty; each step >= 1
  RegionGrid(Volume& volume, const GridBox& box, const GridSize& every);

  const GridSize& size() const override { return size_; }
  void read_slice(std::size_t k, std::span<double> out) override;

 private:
  Volume& volume_;
  GridBox box_;
  GridSize every_;
  GridSize size_{};
  std::vector<double> slice_;  ///< of the volume
};

}  // namespace stream_recon
