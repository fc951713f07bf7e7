// A volume in one file with a header (and perhaps files with voxels that the header names).
//
// Guarantees: geometry is ITK's. Memory: one slice of NIfTI, NRRD and MetaImage, also packed; of
// other formats, and of rare variants of these, what open_itk_volume says.
#pragma once

#include <memory>
#include <string>

#include "tools/slices/volume.h"

namespace stream_recon {

/// \throw InputError
std::unique_ptr<Volume> open_volume_file(const std::string& path);

}  // namespace stream_recon
