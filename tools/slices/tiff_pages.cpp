#include "tools/slices/tiff_pages.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "io/error.h"
#include "tools/slices/bit_rows.h"
#include "tools/slices/tiff_directories.h"
#include "tools/slices/unpacked_file.h"
#include "tools/slices/voxel_bytes.h"

namespace stream_recon {
namespace {

std::optional<RawType> type_of(unsigned bits, unsigned format) {
  const bool is_signed = format == SAMPLEFORMAT_INT;
  if (format == SAMPLEFORMAT_IEEEFP) {
    if (bits == 32) return RawType::kFloat32;
    if (bits == 64) return RawType::kFloat64;
    return std::nullopt;
  }
  if (format != SAMPLEFORMAT_UINT && format != SAMPLEFORMAT_VOID && !is_signed) return std::nullopt;
  switch (bits) {
    case 1:
    case 2:
    case 4:
      return RawType::kUint8;
    case 8:
      return is_signed ? RawType::kInt8 : RawType::kUint8;
    case 16:
      return is_signed ? RawType::kInt16 : RawType::kUint16;
    case 32:
      return is_signed ? RawType::kInt32 : RawType::kUint32;
    default:
      return std::nullopt;
  }
}

template <typename Number>
Number field(TIFF* tiff, std::uint32_t tag, Number missing) {
  Number value = missing;
  TIFFGetFieldDefaulted(tiff, tag, &value);
  return value;
}

}  // namespace

TiffPages::TiffPages(const std::string& path) : path_(path), directories_(tiff_directories(path)) {
  TIFFOpenOptions* options = TIFFOpenOptionsAlloc();
  TIFFOpenOptionsSetErrorHandlerExtR(options, keep_reason, this);
  TIFFOpenOptionsSetWarningHandlerExtR(options, ignore, nullptr);
  // h: the first directory is not read yet; m: not mapped, so that a file cut meanwhile is an error
  tiff_ = TIFFOpenExt(path.c_str(), "rhm", options);
  TIFFOpenOptionsFree(options);
  if (tiff_ == nullptr) fail();
}

TiffPages::~TiffPages() {
  if (tiff_ != nullptr) TIFFClose(tiff_);
}

int TiffPages::keep_reason(TIFF*, void* self, const char*, const char* format, va_list values) {
  std::array<char, 256> text{};
  std::vsnprintf(text.data(), text.size(), format, values);
  auto& reason = static_cast<TiffPages*>(self)->reason_;
  if (reason.empty()) reason = text.data();
  return 1;
}

void TiffPages::fail() const {
  refuse_damaged_image(path_, reason_.empty() ? "no reason given" : reason_);
}

ImageShape TiffPages::open(std::size_t page) {
  reason_.clear();
  if (TIFFSetSubDirectory(tiff_, directories_[page]) == 0) fail();
  const auto samples = field<std::uint16_t>(tiff_, TIFFTAG_SAMPLESPERPIXEL, 1);
  const auto photometric = field<std::uint16_t>(tiff_, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
  zero_is_white_ = photometric == PHOTOMETRIC_MINISWHITE;
  if (samples != 1 ||
      (photometric != PHOTOMETRIC_MINISBLACK && !zero_is_white_ && photometric != PHOTOMETRIC_MASK))
    refuse_color(path_);
  const auto bits = field<std::uint16_t>(tiff_, TIFFTAG_BITSPERSAMPLE, 1);
  const auto format = field<std::uint16_t>(tiff_, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT);
  const auto type = type_of(bits, format);
  if (!type) {
    throw InputError(fmt::format("{}: {}-bit pixels of format {}; convert it to 8 or 16 bit grey",
                                 path_, bits, format));
  }
  shape_ = {field<std::uint32_t>(tiff_, TIFFTAG_IMAGEWIDTH, 0),
            field<std::uint32_t>(tiff_, TIFFTAG_IMAGELENGTH, 0), bits, *type};
  if (shape_.width == 0 || shape_.height == 0) refuse_damaged_image(path_, "a page without pixels");
  check_places();
  return shape_;
}

/// A strip or tile that reaches beyond the end of the file has been cut off.
void TiffPages::check_places() {
  const std::uint64_t length = length_of_file(path_);
  const bool tiled = TIFFIsTiled(tiff_) != 0;
  const std::uint32_t count = tiled ? TIFFNumberOfTiles(tiff_) : TIFFNumberOfStrips(tiff_);
  for (std::uint32_t n = 0; n < count; ++n) {
    const std::uint64_t at = TIFFGetStrileOffset(tiff_, n);
    const std::uint64_t bytes = TIFFGetStrileByteCount(tiff_, n);
    if (at <= length && bytes <= length - at) continue;
    refuse_damaged_image(path_, fmt::format("pixels at bytes {} to {}, but the file has {}", at,
                                            at + bytes, length));
  }
}

void TiffPages::read(std::span<double> out) {
  if (TIFFIsTiled(tiff_) != 0) {
    read_tiles(out);
  } else {
    read_strips(out);
  }
  if (!zero_is_white_ || is_floating(shape_.type)) return;
  const bool is_signed = shape_.type == RawType::kInt8 || shape_.type == RawType::kInt16 ||
                         shape_.type == RawType::kInt32;
  const double white = is_signed ? -1 : std::ldexp(1.0, static_cast<int>(shape_.bits)) - 1;
  for (double& voxel : out) voxel = white - voxel;
}

void TiffPages::widen_row(const std::byte* row, std::span<double> out) const {
  if (shape_.bits < 8) {
    widen_bits(row, shape_.bits, out);
  } else {
    widen_voxels(row, {shape_.type, std::endian::native}, out);  // libtiff has turned the bytes
  }
}

void TiffPages::read_strips(std::span<double> out) {
  std::vector<std::byte> row(static_cast<std::size_t>(TIFFScanlineSize64(tiff_)));
  for (std::size_t y = 0; y < shape_.height; ++y) {
    if (TIFFReadScanline(tiff_, row.data(), static_cast<std::uint32_t>(y), 0) < 0 ||
        !reason_.empty())
      fail();
    widen_row(row.data(), out.subspan(y * shape_.width, shape_.width));
  }
}

void TiffPages::read_tiles(std::span<double> out) {
  const std::size_t width = field<std::uint32_t>(tiff_, TIFFTAG_TILEWIDTH, 0);
  const std::size_t height = field<std::uint32_t>(tiff_, TIFFTAG_TILELENGTH, 0);
  std::vector<std::byte> tile(static_cast<std::size_t>(TIFFTileSize64(tiff_)));
  const auto row_bytes = static_cast<std::size_t>(TIFFTileRowSize64(tiff_));
  if (width == 0 || row_bytes * height > tile.size()) fail();
  for (std::size_t y = 0; y < shape_.height; y += height) {
    for (std::size_t x = 0; x < shape_.width; x += width) {
      const auto n = TIFFComputeTile(tiff_, static_cast<std::uint32_t>(x),
                                     static_cast<std::uint32_t>(y), 0, 0);
      const auto size = static_cast<tmsize_t>(tile.size());
      if (TIFFReadEncodedTile(tiff_, n, tile.data(), size) < size || !reason_.empty()) fail();
      for (std::size_t row = 0; row < std::min(height, shape_.height - y); ++row) {
        widen_row(tile.data() + row * row_bytes,
                  out.subspan((y + row) * shape_.width + x, std::min(width, shape_.width - x)));
      }
    }
  }
}

std::size_t TiffPages::undescribed_pages() const {
  char* text = nullptr;
  if (size() != 1 || TIFFGetField(tiff_, TIFFTAG_IMAGEDESCRIPTION, &text) == 0) return 0;
  const std::string description(text);
  const std::size_t at = description.find("\nimages=");
  if (!description.starts_with("ImageJ=") || at == std::string::npos) return 0;
  const long pages = std::atol(description.c_str() + at + 8);
  return pages > 1 ? static_cast<std::size_t>(pages) : 0;
}

std::uint64_t TiffPages::start_of_plain_pixels() const {
  if (field<std::uint16_t>(tiff_, TIFFTAG_COMPRESSION, COMPRESSION_NONE) != COMPRESSION_NONE ||
      TIFFIsTiled(tiff_) != 0 || shape_.bits < 8 || zero_is_white_) {
    throw InputError(
        fmt::format("{}: pages without description that are packed; save it anew as "
                    "BigTIFF, or page by page",
                    path_));
  }
  return TIFFGetStrileOffset(tiff_, 0);
}

std::endian TiffPages::byte_order() const {
  return TIFFIsBigEndian(tiff_) != 0 ? std::endian::big : std::endian::little;
}

}  // namespace stream_recon
