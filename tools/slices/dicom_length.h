// Does a DICOM file hold all of the bytes that its elements announce? GDCM makes up what is missing
// of the voxels, and ends the process over a header that is cut off.
//
// Cost: some hundred small reads; voxels are stepped over.
// Source: DICOM PS3.5, 7.1 (elements), 7.5 (sequences), A.4 (fragments); PS3.10, 7.1 (file).
#pragma once

#include <string>

namespace stream_recon {

/// A file without the letters DICM, deflated, or of elements that make no sense, is not judged.
/// \throw InputError truncated
void check_dicom_length(const std::string& path);

}  // namespace stream_recon
