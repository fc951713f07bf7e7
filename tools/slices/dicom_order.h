// DICOM slices in their order along the normal, and the grid that they make.
#pragma once

#include <string>
#include <vector>

#include "tools/slices/dicom_header.h"
#include "tools/slices/volume.h"

namespace stream_recon {

struct DicomOrder {
  std::vector<std::string> paths;  ///< slice 0 first: ascending along row x column
  VolumeGeometry geometry;
};

/// Two slices or more.
/// \throw InputError slices that differ, lack a place, share one, or lie unevenly
DicomOrder order_dicom_slices(std::vector<DicomHeader> slices);

}  // namespace stream_recon
