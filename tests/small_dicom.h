// Small DICOM files, element by element: explicit VR, little endian.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace stream_recon {

struct SmallDicom {
  std::string series = "1.2.3.1";
  std::string description = "Thorax";
  int number = 1;
  std::optional<std::string> position = "0\\0\\0";
  std::string orientation = "1\\0\\0\\0\\1\\0";
  std::optional<std::string> pixel_spacing = "0.5\\0.25";  ///< down a column, along a row
  std::uint16_t columns = 3, rows = 2;
  std::string slope = "1", intercept = "0";
  int frames = 1;
  bool has_image = true;
  std::vector<std::int16_t> voxels;
};

namespace small_dicom {

inline std::string number(std::uint32_t value, int bytes) {
  std::string text;
  for (int n = 0; n < bytes; ++n) text += static_cast<char>(value >> 8 * n);
  return text;
}

inline std::string element(std::uint16_t group, std::uint16_t tag, const std::string& type,
                           std::string value) {
  if (value.size() % 2 != 0) value += type == "UI" || type == "OB" ? '\0' : ' ';
  const auto size = static_cast<std::uint32_t>(value.size());
  const std::string head = number(group, 2) + number(tag, 2) + type;
  const bool is_long = type == "OB" || type == "OW";
  return head + (is_long ? number(0, 2) + number(size, 4) : number(size, 2)) + value;
}

}  // namespace small_dicom

inline std::string bytes_of(const SmallDicom& file) {
  using small_dicom::element;
  using small_dicom::number;
  const std::string ct =
      file.has_image ? "1.2.840.10008.5.1.4.1.1.2" : "1.2.840.10008.5.1.4.1.1.88.11";
  const std::string instance = file.series + "." + std::to_string(file.number);
  const std::string meta = element(2, 1, "OB", std::string("\0\1", 2)) + element(2, 2, "UI", ct) +
                           element(2, 3, "UI", instance) +
                           element(2, 0x10, "UI", "1.2.840.10008.1.2.1");
  std::string bytes = std::string(128, '\0') + "DICM" +
                      element(2, 0, "UL", number(static_cast<std::uint32_t>(meta.size()), 4)) +
                      meta + element(8, 0x16, "UI", ct) + element(8, 0x18, "UI", instance) +
                      element(8, 0x60, "CS", file.has_image ? "CT" : "SR") +
                      element(8, 0x103e, "LO", file.description) +
                      element(0x20, 0xd, "UI", "1.2.3") + element(0x20, 0xe, "UI", file.series) +
                      element(0x20, 0x13, "IS", std::to_string(file.number));
  if (!file.has_image) return bytes;
  if (file.position) {
    bytes += element(0x20, 0x32, "DS", *file.position);
    bytes += element(0x20, 0x37, "DS", file.orientation);
  }
  bytes += element(0x28, 2, "US", number(1, 2)) + element(0x28, 4, "CS", "MONOCHROME2");
  if (file.frames > 1) bytes += element(0x28, 8, "IS", std::to_string(file.frames));
  bytes += element(0x28, 0x10, "US", number(file.rows, 2)) +
           element(0x28, 0x11, "US", number(file.columns, 2));
  if (file.pixel_spacing) bytes += element(0x28, 0x30, "DS", *file.pixel_spacing);
  bytes += element(0x28, 0x100, "US", number(16, 2)) + element(0x28, 0x101, "US", number(16, 2)) +
           element(0x28, 0x102, "US", number(15, 2)) + element(0x28, 0x103, "US", number(1, 2)) +
           element(0x28, 0x1052, "DS", file.intercept) + element(0x28, 0x1053, "DS", file.slope);
  std::string pixels;
  for (int n = 0; n < file.columns * file.rows * file.frames; ++n) {
    const auto at = static_cast<std::size_t>(n);
    const int value = at < file.voxels.size() ? file.voxels[at] : 100 * file.number + n;
    pixels += number(static_cast<std::uint16_t>(value), 2);
  }
  return bytes + element(0x7fe0, 0x10, "OW", pixels);
}

}  // namespace stream_recon
