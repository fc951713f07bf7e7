// What the header of a DICOM file says about the place and the series of its slice.
//
// Guarantees: GDCM prints nothing. Memory: one file. Cost: each file is read twice. Thread rule: as
// itk_file.h. Source: DICOM PS3.3, C.7.6.2 (image plane), C.7.3.1 (series).
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "spatial/point.h"

namespace stream_recon {

struct DicomHeader {
  std::string path;
  std::string series, description;
  std::size_t rows = 0, columns = 0;  ///< 0: no image
  bool has_all_voxels = true;         ///< there are as many bytes as the rest of the header says
  std::size_t frames = 1;
  bool is_directory = false;                           ///< a DICOMDIR
  std::optional<Point3> position;                      ///< centre of the first voxel, mm
  std::optional<std::array<Point3, 2>> axes;           ///< unit vectors along a row, down a column
  std::optional<std::array<double, 2>> pixel_spacing;  ///< along a row, down a column, mm
};

/// By the first bytes, or what GDCM thinks of a file that is named as DICOM files are.
bool is_dicom(const std::string& path);

/// In the order of the paths. \throw InputError one is unreadable or truncated
std::vector<DicomHeader> read_dicom_headers(const std::vector<std::string>& paths);

}  // namespace stream_recon
