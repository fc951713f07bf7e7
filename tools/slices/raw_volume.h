// Voxels without a header: one file of all slices, or one file a slice (or several equal files).
//
// Guarantees: files are exactly as long as the layout says, else they are refused with both
// numbers. Spacing is not known. Memory: one slice.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tools/slices/raw_layout.h"
#include "tools/slices/volume.h"

namespace stream_recon {

/// \throw InputError \throw std::invalid_argument no voxels along an axis
std::unique_ptr<Volume> open_raw_volume(const std::vector<std::string>& paths,
                                        const RawLayout& layout);

}  // namespace stream_recon
