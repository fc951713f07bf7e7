// Is a NIfTI or Analyze volume as long as its header says? ITK's reader fills what is missing with
// zeros and says nothing.
//
// Memory: 64 KiB. Cost: a packed file is unpacked once; of a plain one only the header is read.
// Source: the NIfTI-1 and NIfTI-2 headers (nifti1.h 2007, nifti2.h 2011, nifti.nimh.nih.gov).
#pragma once

#include <string>

namespace stream_recon {

/// \throw InputError truncated or damaged
void check_nifti_length(const std::string& path);

}  // namespace stream_recon
