// What the header of a DICOM file says about the place and the series of its slice.
//
// Guarantees: GDCM prints nothing. Memory: the header. Thread rule: as itk_file.h.
// Source: DICOM PS3.3, C.7.6.2 (image plane), C.7.3.1 (series).
#pragma once

#include <array>
#include <optional>
#include <string>

#include "spatial/point.h"

namespace stream_recon {

struct DicomHeader {
  std::string path;
  std::string series, description;
  std::size_t rows = 0, columns = 0;  ///< 0: no image
  std::size_t frames = 1;
  bool is_directory = false;                           ///< a DICOMDIR
  std::optional<Point3> position;                      ///< centre of the first voxel, mm
  std::optional<std::array<Point3, 2>> axes;           ///< unit vectors along a row, down a column
  std::optional<std::array<double, 2>> pixel_spacing;  ///< along a row, down a column, mm
};

/// By the first bytes, or what GDCM thinks of a file that is named as DICOM files are.
bool is_dicom(const std::string& path);

/// \throw InputError unreadable or truncated
DicomHeader read_dicom_header(const std::string& path);

}  // namespace stream_recon
