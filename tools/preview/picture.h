// A picture of red, green and blue bytes, and its PNG file.
//
// Guarantees: the file appears under its name when complete; equal pictures make equal files (with
// one version of libpng and zlib). Memory: 3 bytes a pixel. Thread rule: one writer.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace stream_recon {

using Rgb = std::array<std::uint8_t, 3>;

class Picture {
 public:
  Picture(std::size_t width, std::size_t height)
      : width_(width), height_(height), pixels_(width * height) {}

  std::size_t width() const { return width_; }
  std::size_t height() const { return height_; }
  /// Row 0 is the top one.
  Rgb& at(std::size_t x, std::size_t y) { return pixels_[y * width_ + x]; }
  const Rgb& at(std::size_t x, std::size_t y) const { return pixels_[y * width_ + x]; }

 private:
  std::size_t width_;
  std::size_t height_;
  std::vector<Rgb> pixels_;
};

/// Writes to the file `path`, "-" for standard output. \throw IoError
void write_png(const Picture& picture, const std::string& path);

}  // namespace stream_recon
