// One grey picture as a slice of a volume.
//
// Guarantees: values are those that are stored, not stretched to the type's range (a 1-bit picture
// has 0 and 1); a palette must be of greys. Colour and opacity are refused, and so is a file that
// is not complete: in its header when it is opened, in its pixels when they are read.
// Memory: PNG the picture in its own type, others a row. Thread rule: one user.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "tools/slices/raw_layout.h"

namespace stream_recon {

struct ImageShape {
  std::size_t width = 0;
  std::size_t height = 0;
  unsigned bits = 8;  ///< of a pixel, as stored
  RawType type = RawType::kUint8;

  bool operator==(const ImageShape&) const = default;
  std::size_t pixels() const { return width * height; }
};

/// "512 x 512 of 8-bit unsigned", for messages.
std::string described(const ImageShape& shape);

class SliceImage {
 public:
  virtual ~SliceImage() = default;

  virtual const ImageShape& shape() const = 0;

  /// Fills `out` with the pixels, row by row from the top. Only once.
  /// \throw InputError truncated or damaged
  virtual void read(std::span<double> out) = 0;
};

enum class ImageKind { kPng, kTiff, kJpeg, kBmp };

/// By the first bytes. \throw InputError no such file
std::optional<ImageKind> image_kind_of(const std::string& path);
std::string_view name_of(ImageKind kind);
bool is_named_as_image(const std::string& path);

/// ".png" of "A.PNG"; empty without one.
std::string lower_ending(const std::string& path);

/// \throw InputError
std::unique_ptr<SliceImage> open_png_image(const std::string& path);
std::unique_ptr<SliceImage> open_jpeg_image(const std::string& path);
std::unique_ptr<SliceImage> open_bmp_image(const std::string& path);

/// \throw InputError always
[[noreturn]] void refuse_unknown_image(const std::string& path);
[[noreturn]] void refuse_color(const std::string& path);
[[noreturn]] void refuse_damaged_image(const std::string& path, const std::string& reason);

}  // namespace stream_recon
