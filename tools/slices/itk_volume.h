// Any volume file that ITK reads: NIfTI, NRRD, MetaImage and many more.
//
// Guarantees: a file that is missing, truncated, no volume, of more than one component a voxel or
// of more than three dimensions is refused with one line. Values are ITK's, rescaled as the file's
// header says, widened to double.
// Memory: where ITK reads parts of the format (uncompressed NRRD, MetaImage and others), one slab
// of at most 16 MiB or one slice; elsewhere (NIfTI among others) the volume in its own voxel type.
#pragma once

#include <memory>
#include <string>

#include "tools/slices/volume.h"

namespace stream_recon {

/// \throw InputError
std::unique_ptr<Volume> open_itk_volume(const std::string& path);

}  // namespace stream_recon
