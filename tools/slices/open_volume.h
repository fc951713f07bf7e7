// The door to every kind of volume: a file, a folder, or slices in a row.
//
// Guarantees: what is truncated, damaged, incomplete or of no single scalar a voxel is refused with
// one line that names the file, here or when its slice is read; nothing else is printed. Values are
// the file's, rescaled as its header says.
// Memory: a few slices, however many there are, but for the few variants that open_itk_volume reads
// whole. Thread rule: one reader, and no other thread that writes to standard output or error.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tools/slices/raw_layout.h"
#include "tools/slices/volume.h"

namespace stream_recon {

struct VolumeRequest {
  std::vector<std::string> paths;  ///< one file, one folder, or several slices in the order given
  std::optional<std::array<double, 3>> spacing;  ///< along i, j, k; replaces the file's
  bool needs_spacing = true;     ///< refuse where neither the file nor `spacing` tells it
  std::string series;            ///< DICOM: SeriesInstanceUID, its ending, or its number from 1
  std::optional<RawLayout> raw;  ///< the files have no header
};

/// \throw InputError unreadable, ambiguous, or of unknown spacing
/// \throw std::invalid_argument no path, or a request that contradicts itself
std::unique_ptr<Volume> open_volume(const VolumeRequest& request);

}  // namespace stream_recon
