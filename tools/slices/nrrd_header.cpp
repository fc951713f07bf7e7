#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

#include "io/error.h"
#include "tools/slices/data_files.h"
#include "tools/slices/volume_headers.h"

namespace stream_recon {
namespace {

/// The fields of a header and the files with the voxels.
struct NrrdFields {
  std::map<std::string, std::string> values;
  std::vector<std::string> files;
  std::uint64_t end = 0;  ///< of an attached header, in bytes
  bool is_attached = true;

  std::string operator[](const std::string& name) const {
    const auto at = values.find(name);
    return at == values.end() ? "" : at->second;
  }
};

std::string lowered(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

NrrdFields read_fields(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  NrrdFields fields;
  std::string line;
  std::getline(file, line);  // the magic, which ITK has seen
  while (std::getline(file, line) && !trimmed(line).empty()) {
    const std::size_t colon = line.find(": ");
    if (line[0] == '#' || colon == std::string::npos) continue;
    const std::string name = lowered(line.substr(0, colon));
    const std::string value = trimmed(line.substr(colon + 2));
    if (name == "data file" || name == "datafile") {
      fields.files = named_data_files(path, value, file);
      fields.is_attached = false;
      if (value.starts_with("LIST")) return fields;
    } else {
      fields.values[name == "byteskip"   ? "byte skip"
                    : name == "lineskip" ? "line skip"
                                         : name] = value;
    }
  }
  if (!fields.is_attached) return fields;
  fields.files = {path};
  fields.end = file ? static_cast<std::uint64_t>(file.tellg()) : length_of_file(path);
  return fields;
}

std::optional<RawType> type_of(const std::string& name) {
  static const std::map<std::string, RawType> kTypes{{"signed char", RawType::kInt8},
                                                     {"int8", RawType::kInt8},
                                                     {"int8_t", RawType::kInt8},
                                                     {"uchar", RawType::kUint8},
                                                     {"unsigned char", RawType::kUint8},
                                                     {"uint8", RawType::kUint8},
                                                     {"uint8_t", RawType::kUint8},
                                                     {"short", RawType::kInt16},
                                                     {"short int", RawType::kInt16},
                                                     {"signed short", RawType::kInt16},
                                                     {"signed short int", RawType::kInt16},
                                                     {"int16", RawType::kInt16},
                                                     {"int16_t", RawType::kInt16},
                                                     {"ushort", RawType::kUint16},
                                                     {"unsigned short", RawType::kUint16},
                                                     {"unsigned short int", RawType::kUint16},
                                                     {"uint16", RawType::kUint16},
                                                     {"uint16_t", RawType::kUint16},
                                                     {"int", RawType::kInt32},
                                                     {"signed int", RawType::kInt32},
                                                     {"int32", RawType::kInt32},
                                                     {"int32_t", RawType::kInt32},
                                                     {"uint", RawType::kUint32},
                                                     {"unsigned int", RawType::kUint32},
                                                     {"uint32", RawType::kUint32},
                                                     {"uint32_t", RawType::kUint32},
                                                     {"longlong", RawType::kInt64},
                                                     {"long long", RawType::kInt64},
                                                     {"long long int", RawType::kInt64},
                                                     {"signed long long", RawType::kInt64},
                                                     {"signed long long int", RawType::kInt64},
                                                     {"int64", RawType::kInt64},
                                                     {"int64_t", RawType::kInt64},
                                                     {"ulonglong", RawType::kUint64},
                                                     {"unsigned long long", RawType::kUint64},
                                                     {"unsigned long long int", RawType::kUint64},
                                                     {"uint64", RawType::kUint64},
                                                     {"uint64_t", RawType::kUint64},
                                                     {"float", RawType::kFloat32},
                                                     {"double", RawType::kFloat64}};
  const auto at = kTypes.find(lowered(name));
  if (at == kTypes.end()) return std::nullopt;
  return at->second;
}

/// Are there lengths or vectors for three axes (or all, if there are fewer)?
bool has_spacing(const NrrdFields& fields) {
  std::string axes = fields["space directions"];
  if (axes.empty()) axes = fields["spacings"];
  std::replace_if(
      axes.begin(), axes.end(), [](char c) { return c == '(' || c == ')'; }, ' ');
  std::istringstream words(axes);
  std::size_t known = 0;
  for (std::string word; words >> word;) {
    // A vector counts once: by all of its numbers, with commas between.
    std::replace(word.begin(), word.end(), ',', ' ');
    std::istringstream numbers(word);
    double length = 0;
    for (std::string number; numbers >> number;)
      length += std::abs(std::strtod(number.c_str(), {}));
    known += std::isfinite(length) && length > 0 ? 1 : 0;
  }
  const int dimensions = std::atoi(fields["dimension"].c_str());
  return known >= static_cast<std::size_t>(std::clamp(dimensions, 1, 3));
}

/// \return false for a skip that is not understood
bool place_voxels(const NrrdFields& fields, VoxelLayout& layout) {
  const long lines = std::atol(fields["line skip"].c_str());
  const long bytes = std::atol(fields["byte skip"].c_str());
  if (lines != 0 || bytes < -1) return false;
  layout.at_end = bytes == -1;
  const auto skip = static_cast<std::uint64_t>(std::max(bytes, 0L));
  if (layout.packing == Packing::kNone) {
    layout.start = fields.end + skip;
    return true;
  }
  layout.start = fields.end;
  layout.unpacked_skip = skip;
  return !layout.at_end;
}

/// Spacings without directions in a space with a name: axes are those of the space. ITK refuses it.
std::optional<VolumeGeometry> geometry_of(const NrrdFields& fields) {
  const bool has_space = !fields["space"].empty() || !fields["space dimension"].empty();
  if (!has_space || fields["spacings"].empty() || !fields["space directions"].empty()) return {};
  if (fields["dimension"] != "3") return {};
  VolumeGeometry geometry;
  std::istringstream sizes(fields["sizes"]);
  for (std::size_t& n : geometry.size)
    if (!(sizes >> n) || n == 0) return {};
  std::istringstream spacings(fields["spacings"]);
  std::array<double, 3> spacing{};
  for (double& length : spacing) {
    std::string word;
    spacings >> word;
    length = std::strtod(word.c_str(), nullptr);
    if (!std::isfinite(length) || length == 0) length = 1;
  }
  geometry.step = {{{spacing[0], 0, 0}, {0, spacing[1], 0}, {0, 0, spacing[2]}}};
  return geometry;
}

}  // namespace

VolumeHeader read_nrrd_header(const std::string& path) {
  const NrrdFields fields = read_fields(path);
  VolumeHeader result;
  result.has_spacing = has_spacing(fields);
  result.geometry = geometry_of(fields);
  const auto type = type_of(fields["type"]);
  const std::string encoding = lowered(fields["encoding"]);
  const bool is_packed = encoding == "gzip" || encoding == "gz";
  if (!type || fields.files.empty() || (!is_packed && encoding != "raw")) return result;
  VoxelLayout layout;
  layout.files = fields.files;
  layout.format.type = *type;
  if (lowered(fields["endian"]) == "big") layout.format.order = std::endian::big;
  layout.packing = is_packed ? Packing::kZlib : Packing::kNone;
  if (place_voxels(fields, layout)) result.layout = layout;
  return result;
}

}  // namespace stream_recon
