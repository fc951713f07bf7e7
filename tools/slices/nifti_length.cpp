#include "tools/slices/nifti_length.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <memory>

#include "io/error.h"

namespace stream_recon {
namespace {

using Header = std::array<char, 540>;

constexpr std::int32_t kNifti1Bytes = 348;
constexpr std::int32_t kNifti2Bytes = 540;

/// Reads numbers of a header in the byte order of its first one.
class HeaderFields {
 public:
  explicit HeaderFields(const Header& bytes) : bytes_(bytes) {
    const auto size = at<std::int32_t>(0);
    swapped_ = size != kNifti1Bytes && size != kNifti2Bytes;
  }

  template <typename Number>
  Number at(std::size_t offset) const {
    std::array<char, sizeof(Number)> raw;
    std::copy_n(bytes_.begin() + offset, raw.size(), raw.begin());
    if (swapped_) std::reverse(raw.begin(), raw.end());
    Number value;
    std::memcpy(&value, raw.data(), sizeof value);
    return value;
  }

 private:
  const Header& bytes_;
  bool swapped_ = false;
};

struct Extent {
  bool own_file = false;  ///< the voxels are in the .img beside the header
  double bytes = 0;       ///< up to the last voxel
};

template <typename Size>
double voxel_bytes(const HeaderFields& header, std::size_t dimensions_at, std::size_t bits_at) {
  double bytes = header.at<std::int16_t>(bits_at) / 8.0;
  const auto count = std::clamp<Size>(header.at<Size>(dimensions_at), 0, 7);
  for (Size d = 1; d <= count; ++d)
    bytes *= static_cast<double>(header.at<Size>(dimensions_at + d * sizeof(Size)));
  return bytes;
}

Extent extent_of(const Header& bytes) {
  const HeaderFields header(bytes);
  if (header.at<std::int32_t>(0) == kNifti2Bytes) {
    return {bytes[5] == 'i', static_cast<double>(header.at<std::int64_t>(168)) +
                                 voxel_bytes<std::int64_t>(header, 16, 14)};
  }
  return {std::strncmp(&bytes[344], "n+1", 3) != 0,
          header.at<float>(108) + voxel_bytes<std::int16_t>(header, 40, 72)};
}

class PackedFile {
 public:
  explicit PackedFile(const std::string& path) : path_(path), file_(gzopen(path.c_str(), "rb")) {
    if (file_ == nullptr) throw InputError(fmt::format("{}: cannot open; check the file", path));
  }
  ~PackedFile() { gzclose(file_); }
  PackedFile(const PackedFile&) = delete;
  PackedFile& operator=(const PackedFile&) = delete;

  std::size_t read(char* out, std::size_t size) {
    const int n = gzread(file_, out, static_cast<unsigned>(size));
    if (n >= 0) return static_cast<std::size_t>(n);
    throw InputError(fmt::format("{}: damaged after {} unpacked bytes; copy the file again", path_,
                                 gztell(file_)));
  }

  /// Length when unpacked.
  double length() {
    if (gzdirect(file_) != 0) return static_cast<double>(std::filesystem::file_size(path_));
    std::array<char, 1 << 16> buffer;
    while (read(buffer.data(), buffer.size()) > 0) {
    }
    int state = Z_OK;
    gzerror(file_, &state);
    if (state != Z_OK) {
      throw InputError(fmt::format("{}: ends within its packed data; copy the file again", path_));
    }
    return static_cast<double>(gztell(file_));
  }

 private:
  std::string path_;
  gzFile file_;
};

/// The file of the voxels beside a header: a.hdr, a.hdr.gz -> a.img, a.img.gz.
std::string voxel_path(std::string path) {
  const std::size_t at = path.rfind(".hdr");
  if (at == std::string::npos) return path;
  path.replace(at, 4, ".img");
  if (std::filesystem::exists(path)) return path;
  return path.ends_with(".gz") ? path.substr(0, path.size() - 3) : path + ".gz";
}

std::string header_path(std::string path) {
  const std::size_t at = path.rfind(".img");
  if (at != std::string::npos) path.replace(at, 4, ".hdr");
  if (std::filesystem::exists(path)) return path;
  return path.ends_with(".gz") ? path.substr(0, path.size() - 3) : path + ".gz";
}

}  // namespace

void check_nifti_length(const std::string& path) {
  Header header{};
  const std::string described_in = header_path(path);
  if (PackedFile(described_in).read(header.data(), header.size()) < kNifti1Bytes) {
    throw InputError(fmt::format("{}: ends within its header; copy the file again", described_in));
  }
  const Extent extent = extent_of(header);
  const std::string voxels = extent.own_file ? voxel_path(described_in) : path;
  const double length = PackedFile(voxels).length();
  if (length >= extent.bytes) return;
  throw InputError(fmt::format("{}: ends at byte {:.0f} of {:.0f}; copy the file again", voxels,
                               length, extent.bytes));
}

}  // namespace stream_recon
