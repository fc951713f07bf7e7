// A volume from DICOM files, each a slice, whatever their names and order; or one file of frames.
//
// Guarantees: slices are of one series, alike, sorted along their normal, at even distances (3 %),
// each place once; values are rescaled as each file says (Hounsfield units for CT); anything else
// is refused with one line that names files and numbers. Geometry is DICOM's: patient space, mm;
// slices that are shifted evenly against each other (a tilted gantry) are.
// Memory: the header data of every slice (300 bytes), and one file. Thread rule: as itk_file.h.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tools/slices/volume.h"

namespace stream_recon {

struct DicomFiles {
  std::string name;                ///< of the folder or the first file, for messages
  std::vector<std::string> paths;  ///< DICOM files; those without an image are passed over
  std::string series;              ///< UID, its ending or its number from 1; may be empty
};

/// \throw InputError
std::unique_ptr<Volume> open_dicom_series(const DicomFiles& files);

}  // namespace stream_recon
