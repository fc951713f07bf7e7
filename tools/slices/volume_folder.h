// What a folder of slices holds: the files that are slices, and their kind.
//
// Guarantees: hidden files, folders and files of other kinds are passed over, but not a file that
// is named like the slices and is none, and not a second kind of pictures. Memory: the names.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/slices/slice_image.h"

namespace stream_recon {

struct FolderSlices {
  std::vector<std::string> paths;  ///< in natural order of the names
  std::optional<ImageKind> kind;   ///< nothing: DICOM
};

/// \throw InputError no slices, mixed kinds, a number missing in the row of the pictures' names
FolderSlices slices_in_folder(const std::string& folder);

/// Files of a folder that may be voxels without a header: all but texts and headers.
/// \throw InputError none, or a number is missing in the row of their names
std::vector<std::string> raw_files_in_folder(const std::string& folder);

}  // namespace stream_recon
