// Source: BITMAPFILEHEADER and BITMAPINFOHEADER (Microsoft, Windows GDI). ITK reads neither 1-bit
// pictures nor notices where a file ends.
#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <vector>

#include "io/error.h"
#include "tools/slices/bit_rows.h"
#include "tools/slices/slice_image.h"
#include "tools/slices/unpacked_file.h"

namespace stream_recon {
namespace {

constexpr std::size_t kHeaderBytes = 54;
constexpr std::size_t kFileHeaderBytes = 14;

class BmpImage : public SliceImage {
 public:
  explicit BmpImage(const std::string& path) : path_(path), file_(path, Packing::kNone, 0) {
    std::array<char, kHeaderBytes> header{};
    read_all(std::as_writable_bytes(std::span(header)));
    const auto number = [&](std::size_t at) {
      return load_scalar<std::int32_t>(&header[at], std::endian::little);
    };
    const auto info_bytes = static_cast<std::uint32_t>(number(14));
    const auto bits = load_scalar<std::uint16_t>(&header[28], std::endian::little);
    if (info_bytes < 40 || info_bytes > 4096 || number(18) <= 0 || number(22) == 0)
      refuse_damaged_image(path_, "not a header of a BMP");
    if (bits > 8) refuse_color(path_);
    if (number(30) != 0 || (bits != 1 && bits != 4 && bits != 8))
      throw InputError(fmt::format("{}: a packed BMP; save it as PNG", path_));
    shape_.width = static_cast<std::size_t>(number(18));
    shape_.height = static_cast<std::size_t>(std::abs(std::int64_t{number(22)}));
    shape_.bits = bits;
    from_top_ = number(22) < 0;
    start_ = static_cast<std::uint32_t>(number(10));
    const auto colors = static_cast<std::uint32_t>(number(46));
    read_palette(kFileHeaderBytes + info_bytes, colors == 0 ? 1U << bits : colors);
    row_bytes_ = (shape_.width * bits + 31) / 32 * 4;
    const std::uint64_t wanted = start_ + row_bytes_ * shape_.height;
    if (length_of_file(path_) < wanted) {
      refuse_damaged_image(path_,
                           fmt::format("{} bytes instead of {}", length_of_file(path_), wanted));
    }
  }

  const ImageShape& shape() const override { return shape_; }

  void read(std::span<double> out) override {
    UnpackedFile pixels(path_, Packing::kNone, start_);
    std::vector<std::byte> row(row_bytes_);
    for (std::size_t n = 0; n < shape_.height; ++n) {
      if (pixels.read(row) < row.size()) refuse_damaged_image(path_, "ends within its pixels");
      const std::size_t y = from_top_ ? n : shape_.height - 1 - n;
      const auto voxels = out.subspan(y * shape_.width, shape_.width);
      widen_bits(row.data(), shape_.bits, voxels);
      for (double& voxel : voxels) voxel = grey_of(static_cast<std::size_t>(voxel));
    }
  }

 private:
  void read_all(std::span<std::byte> out) {
    if (file_.read(out) < out.size()) refuse_damaged_image(path_, "ends within its header");
  }

  void read_palette(std::uint64_t at, std::uint32_t count) {
    if (count > 256) refuse_damaged_image(path_, "palette too long");
    file_.skip(at - file_.position());
    std::vector<std::byte> colors(std::size_t{4} * count);
    read_all(colors);
    for (std::size_t n = 0; n < count; ++n) {
      const auto* color = &colors[4 * n];
      if (color[0] != color[1] || color[0] != color[2]) refuse_color(path_);
      greys_.push_back(std::to_integer<int>(color[0]));
    }
    // Black and white are 0 and 1, as in every 1-bit picture.
    if (shape_.bits == 1)
      for (double& grey : greys_) grey = grey > 127 ? 1 : 0;
  }

  double grey_of(std::size_t index) const {
    if (index >= greys_.size()) refuse_damaged_image(path_, "a colour beyond the palette");
    return greys_[index];
  }

  std::string path_;
  UnpackedFile file_;
  ImageShape shape_;
  bool from_top_ = false;
  std::uint64_t start_ = 0;
  std::size_t row_bytes_ = 0;
  std::vector<double> greys_;
};

}  // namespace

std::unique_ptr<SliceImage> open_bmp_image(const std::string& path) {
  return std::make_unique<BmpImage>(path);
}

}  // namespace stream_recon
