// A volume file as ITK sees it: its reader, which has read the header, and its geometry.
//
// Guarantees: a file that is missing, no volume, of more than one component a voxel or of more than
// three dimensions is refused with one line, and ITK prints nothing. Thread rule: one user, and no
// other thread that writes to standard output or error.
#pragma once

#include <itkImageIOBase.h>

#include <functional>
#include <string>

#include "tools/slices/volume.h"

namespace stream_recon {

struct ItkFile {
  std::string path;
  itk::ImageIOBase::Pointer reader;
  VolumeGeometry geometry;
};

/// \throw InputError
ItkFile open_itk_file(const std::string& path);

/// With a reader of a format that is known. \throw InputError
ItkFile open_itk_file(const std::string& path, itk::ImageIOBase::Pointer reader);

/// Runs `work`, silently, and turns its exceptions into an InputError about `path`.
void call_itk(const std::string& path, const std::function<void()>& work);

}  // namespace stream_recon
