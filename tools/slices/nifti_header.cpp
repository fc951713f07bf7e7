#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "io/error.h"
#include "tools/slices/volume_headers.h"

namespace stream_recon {
namespace {

constexpr std::size_t kNifti1Bytes = 348;
constexpr std::size_t kNifti2Bytes = 540;

/// Places of the fields, which differ between the versions of the format.
struct FieldPlaces {
  std::size_t type, spacing, start, slope, intercept, qform, sform;
};
constexpr FieldPlaces kNifti1{70, 76, 108, 112, 116, 252, 254};
constexpr FieldPlaces kNifti2{12, 104, 168, 176, 184, 344, 348};

class NiftiHeader {
 public:
  explicit NiftiHeader(const std::string& path) {
    UnpackedFile file(path, packing_of(path), 0);
    const std::size_t size = file.read(std::as_writable_bytes(std::span(bytes_)));
    for (const std::endian order : {std::endian::little, std::endian::big}) {
      const auto first = load_scalar<std::int32_t>(bytes_.data(), order);
      if (first == kNifti2Bytes) is_second_ = true;
      if (first == kNifti1Bytes || first == kNifti2Bytes) order_ = order;
    }
    if (size >= (is_second_ ? kNifti2Bytes : kNifti1Bytes)) return;
    throw InputError(fmt::format("{}: ends within its header; copy the file again", path));
  }

  std::endian order() const { return order_; }
  bool is_analyze() const { return !is_second_ && (bytes_[344] != 'n' || bytes_[347] != '\0'); }
  bool has_own_voxel_file() const {
    if (is_second_) return bytes_[5] == 'i';
    return is_analyze() || bytes_[345] == 'i';
  }

  int type() const { return at<std::int16_t>(places().type); }
  double start() const { return at_either<float, std::int64_t>(places().start); }
  double slope() const { return at_either<float, double>(places().slope); }
  double intercept() const { return at_either<float, double>(places().intercept); }
  double spacing(std::size_t axis) const {
    const std::size_t size = is_second_ ? sizeof(double) : sizeof(float);
    return at_either<float, double>(places().spacing + (1 + axis) * size);
  }
  bool has_sform() const { return at_either<std::int16_t, std::int32_t>(places().sform) > 0; }

 private:
  const FieldPlaces& places() const { return is_second_ ? kNifti2 : kNifti1; }

  template <typename Number>
  Number at(std::size_t offset) const {
    return load_scalar<Number>(&bytes_[offset], order_);
  }
  template <typename First, typename Second>
  double at_either(std::size_t offset) const {
    return is_second_ ? static_cast<double>(at<Second>(offset))
                      : static_cast<double>(at<First>(offset));
  }

  std::array<char, kNifti2Bytes> bytes_{};
  std::endian order_ = std::endian::little;
  bool is_second_ = false;
};

std::optional<RawType> type_of(int code) {
  switch (code) {
    case 2:
      return RawType::kUint8;
    case 4:
      return RawType::kInt16;
    case 8:
      return RawType::kInt32;
    case 16:
      return RawType::kFloat32;
    case 64:
      return RawType::kFloat64;
    case 256:
      return RawType::kInt8;
    case 512:
      return RawType::kUint16;
    case 768:
      return RawType::kUint32;
    case 1024:
      return RawType::kInt64;
    case 1280:
      return RawType::kUint64;
    default:
      return std::nullopt;
  }
}

/// The other file of a pair: a.hdr <-> a.img, each perhaps packed.
std::string partner(std::string path, const std::string& from, const std::string& to) {
  const std::size_t at = path.rfind(from);
  if (at == std::string::npos) return path;
  path.replace(at, from.size(), to);
  if (std::filesystem::exists(path)) return path;
  const std::string other = path.ends_with(".gz") ? path.substr(0, path.size() - 3) : path + ".gz";
  return std::filesystem::exists(other) ? other : path;
}

bool has_spacing(const NiftiHeader& header) {
  if (header.has_sform()) return true;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double spacing = std::abs(header.spacing(axis));
    if (!std::isfinite(spacing) || spacing == 0) return false;
  }
  return true;
}

}  // namespace

VolumeHeader read_nifti_header(const std::string& path) {
  const std::string described_in = partner(path, ".img", ".hdr");
  const NiftiHeader header(described_in);
  VolumeHeader result;
  result.has_spacing = has_spacing(header);
  const auto type = type_of(header.type());
  const double start = header.start();
  if (!type || !(start >= 0) || start > 0x1p53) return result;
  VoxelLayout layout;
  const bool is_pair = header.has_own_voxel_file();
  layout.files = {is_pair ? partner(described_in, ".hdr", ".img") : path};
  layout.format = {*type, header.order()};
  layout.packing = packing_of(layout.files[0]);
  const auto first = static_cast<std::uint64_t>(start);
  (layout.packing == Packing::kNone ? layout.start : layout.unpacked_skip) =
      is_pair ? first : std::max<std::uint64_t>(first, kNifti1Bytes);
  if (!header.is_analyze() && header.slope() != 0) {
    layout.slope = header.slope();
    layout.intercept = header.intercept();
  }
  result.layout = layout;
  return result;
}

}  // namespace stream_recon
