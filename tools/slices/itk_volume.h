// The voxels of a file as ITK's own reader gives them, for formats that have no reader here.
//
// Guarantees: a file whose last voxels are missing is refused with one line. Values are ITK's,
// rescaled as the file's header says, widened to double.
// Memory: where ITK reads parts of the format, one slab of at most 16 MiB or one slice; elsewhere
// the volume in its own voxel type. Thread rule: as itk_file.h.
#pragma once

#include <memory>

#include "tools/slices/itk_file.h"

namespace stream_recon {

/// \throw InputError
std::unique_ptr<Volume> open_itk_volume(ItkFile file);

}  // namespace stream_recon
