#include "tools/preview/picture.h"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "io/atomic_output.h"

namespace stream_recon {
namespace {

/// One row as the file has it.
void fill_row(const Picture& picture, std::size_t y, bool is_opaque,
              std::vector<std::uint8_t>& row) {
  row.clear();
  for (std::size_t x = 0; x < picture.width(); ++x) {
    const Rgb& color = picture.at(x, y);
    row.insert(row.end(), color.begin(), color.end());
    if (!is_opaque) row.push_back(picture.opacity(x, y));
  }
}

void append(png_structp png, png_bytep data, std::size_t size) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(data), size);
}

[[noreturn]] void fail(png_structp, png_const_charp message) {
  throw std::runtime_error(std::string("cannot encode the picture: ") + message);
}

void ignore(png_structp, png_const_charp) {}

void encode_rows(png_structp png, png_infop info, const Picture& picture) {
  const bool is_opaque = picture.is_opaque();
  png_set_IHDR(png, info, static_cast<png_uint_32>(picture.width()),
               static_cast<png_uint_32>(picture.height()), 8,
               is_opaque ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGB_ALPHA, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_compression_level(png, 6);
  png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_ALL_FILTERS);
  png_write_info(png, info);
  std::vector<std::uint8_t> row;
  row.reserve(4 * picture.width());
  for (std::size_t y = 0; y < picture.height(); ++y) {
    fill_row(picture, y, is_opaque, row);
    png_write_row(png, row.data());
  }
  png_write_end(png, info);
}

std::uint8_t mix(float from, std::uint8_t to, float share) {
  return static_cast<std::uint8_t>(
      std::lround(from + (static_cast<float>(to) - from) * std::clamp(share, 0.0F, 1.0F)));
}

}  // namespace

bool Picture::is_opaque() const {
  return std::all_of(opacity_.begin(), opacity_.end(), [](auto byte) { return byte == 255; });
}

void Picture::blend(std::ptrdiff_t x, std::ptrdiff_t y, const Rgb& color, float coverage) {
  if (x < 0 || y < 0 || x >= static_cast<std::ptrdiff_t>(width_) ||
      y >= static_cast<std::ptrdiff_t>(height_) || coverage <= 0) {
    return;
  }
  const std::size_t at = static_cast<std::size_t>(y) * width_ + static_cast<std::size_t>(x);
  const float below = static_cast<float>(opacity_[at]) / 255 * (1 - coverage);
  const float opacity = coverage + below;
  for (int i = 0; i < 3; ++i) pixels_[at][i] = mix(pixels_[at][i], color[i], coverage / opacity);
  opacity_[at] = static_cast<std::uint8_t>(std::lround(255 * std::min(1.0F, opacity)));
}

void Picture::paste(const Picture& part, std::size_t x) {
  for (std::size_t y = 0; y < height_; ++y) {
    for (std::size_t column = 0; column < part.width(); ++column) {
      at(x + column, y) = part.at(column, y);
      opacity(x + column, y) = part.opacity(column, y);
    }
  }
}

std::string encode_png(const Picture& picture) {
  std::string bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, fail, ignore);
  png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
  if (info == nullptr) throw std::bad_alloc();
  png_set_write_fn(png, &bytes, append, nullptr);
  encode_rows(png, info, picture);
  png_destroy_write_struct(&png, &info);
  return bytes;
}

void write_png(const Picture& picture, const std::string& path) {
  write_output(path, encode_png(picture));
}

}  // namespace stream_recon
