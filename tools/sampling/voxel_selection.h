// Which voxels belong to the object.
//
// Voxels that are not finite never do. Thread rule: a value.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace stream_recon {

class VoxelSelection {
 public:
  static VoxelSelection above(double value) { return {Kind::kAbove, {value}}; }
  static VoxelSelection at_least(double value) { return {Kind::kAtLeast, {value}}; }
  /// Voxels that have one of `labels`, at least one.
  static VoxelSelection of_labels(std::vector<double> labels);
  /// Voxels that are not 0.
  static VoxelSelection any_label() { return {Kind::kNotZero, {}}; }

  /// Sets `inside` to 1 where the voxel belongs to the object, else 0; both of one length.
  void mark(std::span<const double> voxels, std::span<std::uint8_t> inside) const;

  bool is_of_labels() const { return kind_ == Kind::kLabels; }

  /// For people: "label 13", "at least -400".
  std::string description() const;

 private:
  enum class Kind { kAbove, kAtLeast, kLabels, kNotZero };
  VoxelSelection(Kind kind, std::vector<double> values) : kind_(kind), values_(std::move(values)) {}

  Kind kind_;
  std::vector<double> values_;  ///< labels ascend
};

}  // namespace stream_recon
