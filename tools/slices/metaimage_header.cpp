#include <fmt/format.h>

#include <fstream>
#include <map>
#include <sstream>

#include "io/error.h"
#include "tools/slices/data_files.h"
#include "tools/slices/volume_headers.h"

namespace stream_recon {
namespace {

struct MetaFields {
  std::map<std::string, std::string> values;
  std::vector<std::string> files;
  std::uint64_t end = 0;  ///< of a header in front of its voxels, in bytes

  std::string operator[](const std::string& name) const {
    const auto at = values.find(name);
    return at == values.end() ? "" : at->second;
  }
  bool is_true(const std::string& name) const {
    const std::string value = (*this)[name];
    return !value.empty() && (value[0] == 'T' || value[0] == 't' || value[0] == '1');
  }
};

MetaFields read_fields(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  MetaFields fields;
  for (std::string line; std::getline(file, line);) {
    const std::size_t equals = line.find_first_of("=:");
    if (equals == std::string::npos) continue;
    const std::string name = trimmed(line.substr(0, equals));
    const std::string value = trimmed(line.substr(equals + 1));
    if (name != "ElementDataFile") {
      fields.values[name] = value;
      continue;
    }
    if (value == "LOCAL" || value == "Local" || value == "local") {
      fields.files = {path};
      fields.end = file ? static_cast<std::uint64_t>(file.tellg()) : length_of_file(path);
    } else {
      fields.files = named_data_files(path, value, file);
    }
    break;
  }
  return fields;
}

/// MET_LONG is left to ITK: how long it is depends on who wrote it.
std::optional<RawType> type_of(const std::string& name) {
  static const std::map<std::string, RawType> kTypes{
      {"MET_CHAR", RawType::kInt8},       {"MET_UCHAR", RawType::kUint8},
      {"MET_SHORT", RawType::kInt16},     {"MET_USHORT", RawType::kUint16},
      {"MET_INT", RawType::kInt32},       {"MET_UINT", RawType::kUint32},
      {"MET_LONG_LONG", RawType::kInt64}, {"MET_ULONG_LONG", RawType::kUint64},
      {"MET_FLOAT", RawType::kFloat32},   {"MET_DOUBLE", RawType::kFloat64}};
  const auto at = kTypes.find(name);
  if (at == kTypes.end()) return std::nullopt;
  return at->second;
}

}  // namespace

VolumeHeader read_metaimage_header(const std::string& path) {
  const MetaFields fields = read_fields(path);
  VolumeHeader result;
  result.has_spacing = !fields["ElementSpacing"].empty() || !fields["ElementSize"].empty();
  const auto type = type_of(fields["ElementType"]);
  if (!type || fields.files.empty() || !fields.is_true("BinaryData")) return result;
  VoxelLayout layout;
  layout.files = fields.files;
  layout.format.type = *type;
  if (fields.is_true("BinaryDataByteOrderMSB") || fields.is_true("ElementByteOrderMSB"))
    layout.format.order = std::endian::big;
  // CompressedDataSize is not believed: files whose header is wrong about it are about.
  if (fields.is_true("CompressedData")) layout.packing = Packing::kZlib;
  const long header_size = std::atol(fields["HeaderSize"].c_str());
  const bool has_odd_start =
      header_size != 0 && (layout.packing != Packing::kNone || fields.end > 0);
  if (header_size < -1 || has_odd_start) return result;
  layout.at_end = header_size == -1;
  layout.start = fields.end + static_cast<std::uint64_t>(std::max(header_size, 0L));
  result.layout = layout;
  return result;
}

}  // namespace stream_recon
