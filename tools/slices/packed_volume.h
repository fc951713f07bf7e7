// A volume whose voxels lie one after the other in files, plain or packed.
//
// Guarantees: plain files that are too short are refused when they are opened, packed ones when the
// slice that is not there is read, or the last one if only the packed data's end is missing.
// Memory: one slice as it lies in the file, and 100 KiB. Cost: a step back begins a packed file
// anew. Thread rule: one reader.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "tools/slices/unpacked_file.h"
#include "tools/slices/volume.h"
#include "tools/slices/voxel_bytes.h"

namespace stream_recon {

struct VoxelLayout {
  std::vector<std::string> files;  ///< each with an equal share of the voxels, in their order
  VoxelFormat format;
  Packing packing = Packing::kNone;
  std::uint64_t start = 0;          ///< bytes of each file before its voxels or packed data
  std::uint64_t unpacked_skip = 0;  ///< of the unpacked bytes, what comes before the voxels
  bool at_end = false;              ///< the voxels end with the file; `start` does not count
  bool exact_length = false;        ///< nothing may follow the voxels
  double slope = 1;                 ///< value = slope * voxel + intercept
  double intercept = 0;
  bool rounds_to_float = false;  ///< the voxel, and the value if it is rescaled
};

/// `source` is what Volume::source() says.
/// \throw InputError a file is missing or too short, or the files cannot share the voxels equally
std::unique_ptr<Volume> open_packed_volume(VoxelLayout layout, const VolumeGeometry& geometry,
                                           const std::string& source);

}  // namespace stream_recon
