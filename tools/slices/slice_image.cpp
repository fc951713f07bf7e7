#include "tools/slices/slice_image.h"

#include <fmt/format.h>

#include <array>
#include <cctype>
#include <filesystem>
#include <set>
#include <string_view>

#include "io/error.h"
#include "tools/slices/unpacked_file.h"
#include "tools/slices/voxel_bytes.h"

namespace stream_recon {

std::string described(const ImageShape& shape) {
  const std::string type = shape.bits == 8 * scalar_size(shape.type)
                               ? std::string(name_of(shape.type))
                               : fmt::format("{}-bit", shape.bits);
  return fmt::format("{} x {} of {}", shape.width, shape.height, type);
}

std::optional<ImageKind> image_kind_of(const std::string& path) {
  std::array<char, 8> bytes{};
  UnpackedFile file(path, Packing::kNone, 0);
  const std::size_t size = file.read(std::as_writable_bytes(std::span(bytes)));
  const std::string_view first(bytes.data(), size);
  const auto begins = [&](std::string_view magic) { return first.starts_with(magic); };
  using namespace std::string_view_literals;
  if (begins("\x89PNG\r\n\x1a\n")) return ImageKind::kPng;
  if (begins("II*\0"sv) || begins("MM\0*"sv) || begins("II+\0"sv) || begins("MM\0+"sv))
    return ImageKind::kTiff;
  if (begins("\xff\xd8\xff")) return ImageKind::kJpeg;
  if (begins("BM")) return ImageKind::kBmp;
  return std::nullopt;
}

std::string_view name_of(ImageKind kind) {
  switch (kind) {
    case ImageKind::kPng:
      return "PNG";
    case ImageKind::kTiff:
      return "TIFF";
    case ImageKind::kJpeg:
      return "JPEG";
    case ImageKind::kBmp:
      return "BMP";
  }
  return "";
}

std::string lower_ending(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return ending;
}

bool is_named_as_image(const std::string& path) {
  static const std::set<std::string> kEndings{".png", ".tif", ".tiff", ".jpg", ".jpeg", ".bmp"};
  return kEndings.contains(lower_ending(path));
}

void refuse_unknown_image(const std::string& path) {
  throw InputError(
      fmt::format("{}: not the image that its name says, or cut off; copy it again", path));
}

void refuse_color(const std::string& path) {
  throw InputError(
      fmt::format("{}: a colour image; extract one channel, or convert it to grey", path));
}

void refuse_damaged_image(const std::string& path, const std::string& reason) {
  throw InputError(fmt::format("{}: truncated or damaged ({}); copy the file again", path, reason));
}

}  // namespace stream_recon
