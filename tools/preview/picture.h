// A picture of red, green, blue and opacity bytes, and its PNG file.
//
// Guarantees: the file appears under its name when complete; equal pictures make equal files (with
// one version of libpng and zlib); opacity is stored only where a pixel is not opaque.
// Memory: 4 bytes a pixel. Thread rule: one writer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "tools/preview/color.h"

namespace stream_recon {

class Picture {
 public:
  /// Black and opaque.
  Picture(std::size_t width, std::size_t height)
      : width_(width), height_(height), pixels_(width * height), opacity_(width * height, 255) {}

  std::size_t width() const { return width_; }
  std::size_t height() const { return height_; }
  /// Row 0 is the top one.
  Rgb& at(std::size_t x, std::size_t y) { return pixels_[y * width_ + x]; }
  const Rgb& at(std::size_t x, std::size_t y) const { return pixels_[y * width_ + x]; }
  /// 0 lets all through, 255 nothing.
  std::uint8_t& opacity(std::size_t x, std::size_t y) { return opacity_[y * width_ + x]; }
  std::uint8_t opacity(std::size_t x, std::size_t y) const { return opacity_[y * width_ + x]; }
  bool is_opaque() const;

  /// Lays `color` over a pixel. \param coverage 0 to 1; nothing happens outside the picture
  void blend(std::ptrdiff_t x, std::ptrdiff_t y, const Rgb& color, float coverage);
  /// Puts `part` with its left edge at column `x`; it has this picture's height and fits.
  void paste(const Picture& part, std::size_t x);

 private:
  std::size_t width_;
  std::size_t height_;
  std::vector<Rgb> pixels_;
  std::vector<std::uint8_t> opacity_;
};

/// The bytes of a PNG file.
std::string encode_png(const Picture& picture);

/// Writes to the file `path`, "-" for standard output. \throw IoError
void write_png(const Picture& picture, const std::string& path);

}  // namespace stream_recon
