#include "tools/preview/picture.h"

#include <png.h>

#include <span>
#include <stdexcept>

#include "io/atomic_output.h"

namespace stream_recon {
namespace {

/// libpng leaves a function by a jump when it fails: nothing here needs a destructor on that way.
void encode_rows(png_structp png, png_infop info, const Picture& picture) {
  png_set_IHDR(png, info, static_cast<png_uint_32>(picture.width()),
               static_cast<png_uint_32>(picture.height()), 8, PNG_COLOR_TYPE_RGB,
               PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_compression_level(png, 9);
  png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_ALL_FILTERS);
  png_write_info(png, info);
  for (std::size_t y = 0; y < picture.height(); ++y) png_write_row(png, picture.at(0, y).data());
  png_write_end(png, info);
}

void append(png_structp png, png_bytep data, std::size_t size) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(data), size);
}

[[noreturn]] void fail(png_structp, png_const_charp message) {
  throw std::runtime_error(std::string("cannot encode the picture: ") + message);
}

void ignore(png_structp, png_const_charp) {}

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

}  // namespace

void write_png(const Picture& picture, const std::string& path) {
  const std::string bytes = encode_png(picture);
  const auto data = std::as_bytes(std::span(bytes));
  if (path == "-") {
    File::standard_output().write(data);
    return;
  }
  AtomicOutput output(path);
  output.file().write(data);
  output.commit();
}

}  // namespace stream_recon
