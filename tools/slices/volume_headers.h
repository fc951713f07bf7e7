// Where the voxels of a volume file lie, as its header tells; the geometry is ITK's business.
//
// Guarantees: a header that says what these readers do not understand gives no layout, never a
// wrong one; ITK then reads the volume whole. Memory: the header.
// Sources: NIfTI-1, NIfTI-2 and Analyze 7.5 headers (nifti1.h 2007, nifti2.h 2011,
// nifti.nimh.nih.gov); the NRRD file format, NRRD0001 to NRRD0005 (teem.sourceforge.net/nrrd);
// MetaIO (itk.org/Wiki/ITK/MetaIO).
#pragma once

#include <optional>
#include <string>

#include "tools/slices/packed_volume.h"

namespace stream_recon {

struct VolumeHeader {
  std::optional<VoxelLayout> layout;
  bool has_spacing = true;                 ///< of all axes
  std::optional<VolumeGeometry> geometry;  ///< where ITK does not understand the header's
};

/// .nii and .hdr/.img, each also with .gz. \throw InputError truncated
VolumeHeader read_nifti_header(const std::string& path);

/// .nrrd and .nhdr; encodings raw and gzip. \throw InputError
VolumeHeader read_nrrd_header(const std::string& path);

/// .mha and .mhd, binary. \throw InputError
VolumeHeader read_metaimage_header(const std::string& path);

}  // namespace stream_recon
