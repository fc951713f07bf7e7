#include <cstdio>  // jpeglib.h needs FILE
// clang-format off
#include <jpeglib.h>
// clang-format on

#include <algorithm>
#include <array>
#include <vector>

#include "tools/slices/c_file.h"
#include "tools/slices/slice_image.h"

namespace stream_recon {
namespace {

class JpegImage : public SliceImage {
 public:
  explicit JpegImage(const std::string& path) : path_(path), file_(open_c_file(path)) {
    jpeg_.err = jpeg_std_error(&errors_);
    errors_.error_exit = fail;
    errors_.emit_message = refuse_warning;
    jpeg_.client_data = &path_;
    jpeg_create_decompress(&jpeg_);
    try {
      jpeg_stdio_src(&jpeg_, file_.get());
      jpeg_read_header(&jpeg_, TRUE);
      if (jpeg_.num_components != 1) refuse_color(path_);
    } catch (...) {
      jpeg_destroy_decompress(&jpeg_);
      throw;
    }
    shape_.width = jpeg_.image_width;
    shape_.height = jpeg_.image_height;
  }
  ~JpegImage() override { jpeg_destroy_decompress(&jpeg_); }
  JpegImage(const JpegImage&) = delete;
  JpegImage& operator=(const JpegImage&) = delete;

  const ImageShape& shape() const override { return shape_; }

  void read(std::span<double> out) override {
    jpeg_start_decompress(&jpeg_);
    std::vector<JSAMPLE> row(shape_.width);
    JSAMPROW rows = row.data();
    for (std::size_t y = 0; y < shape_.height; ++y) {
      jpeg_read_scanlines(&jpeg_, &rows, 1);
      std::copy(row.begin(), row.end(), out.begin() + static_cast<std::ptrdiff_t>(y * row.size()));
    }
    jpeg_finish_decompress(&jpeg_);  // reads to the end of the image
  }

 private:
  [[noreturn]] static void fail(j_common_ptr jpeg) {
    std::array<char, JMSG_LENGTH_MAX> reason{};
    jpeg->err->format_message(jpeg, reason.data());
    refuse_damaged_image(*static_cast<const std::string*>(jpeg->client_data), reason.data());
  }
  /// libjpeg fills what is missing with grey and calls that a warning.
  static void refuse_warning(j_common_ptr jpeg, int level) {
    if (level < 0) fail(jpeg);
  }

  std::string path_;
  CFile file_;
  jpeg_error_mgr errors_{};
  jpeg_decompress_struct jpeg_{};
  ImageShape shape_;
};

}  // namespace

std::unique_ptr<SliceImage> open_jpeg_image(const std::string& path) {
  return std::make_unique<JpegImage>(path);
}

}  // namespace stream_recon
