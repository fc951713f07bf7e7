// Grey pictures as the slices of a volume: one file each, or the pages of a TIFF file.
//
// Guarantees: all slices have one size and type, which is seen when the stack is opened; the
// distance of pixels and slices is not known (what a picture says of dots per inch is not
// believed). Memory: one slice in its own type, and the paths. Thread rule: one reader.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tools/slices/slice_image.h"
#include "tools/slices/volume.h"

namespace stream_recon {

/// The pictures in the order given; a single TIFF file may have several pages.
/// \throw InputError a file is no picture of `kind`, or differs from the first
std::unique_ptr<Volume> open_image_stack(ImageKind kind, const std::vector<std::string>& paths);

}  // namespace stream_recon
