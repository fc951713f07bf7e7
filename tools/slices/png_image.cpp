#include <png.h>

#include <array>
#include <new>
#include <vector>

#include "tools/slices/c_file.h"
#include "tools/slices/slice_image.h"
#include "tools/slices/voxel_bytes.h"

namespace stream_recon {
namespace {

class PngImage : public SliceImage {
 public:
  explicit PngImage(const std::string& path) : path_(path), file_(open_c_file(path)) {
    png_.reset(png_create_read_struct(PNG_LIBPNG_VER_STRING, &path_, fail, ignore));
    if (!png_ || png_.make_info() == nullptr) throw std::bad_alloc();
    png_init_io(png_.get(), file_.get());
    png_read_info(png_.get(), png_.info());
    shape_.width = png_get_image_width(png_.get(), png_.info());
    shape_.height = png_get_image_height(png_.get(), png_.info());
    shape_.bits = png_get_bit_depth(png_.get(), png_.info());
    shape_.type = shape_.bits == 16 ? RawType::kUint16 : RawType::kUint8;
    prepare_greys();
  }

  const ImageShape& shape() const override { return shape_; }

  void read(std::span<double> out) override {
    if (shape_.bits < 8) png_set_packing(png_.get());
    png_set_interlace_handling(png_.get());
    png_read_update_info(png_.get(), png_.info());
    const std::size_t row_bytes = png_get_rowbytes(png_.get(), png_.info());
    std::vector<std::byte> bytes(row_bytes * shape_.height);
    std::vector<png_bytep> rows(shape_.height);
    for (std::size_t y = 0; y < rows.size(); ++y)
      rows[y] = reinterpret_cast<png_bytep>(bytes.data() + y * row_bytes);
    png_read_image(png_.get(), rows.data());
    png_read_end(png_.get(), nullptr);  // sees that the checksums and the end are there
    widen_voxels(bytes.data(), {shape_.type, std::endian::big}, out);
    if (greys_.empty()) return;
    for (double& voxel : out) {
      const auto index = static_cast<std::size_t>(voxel);
      if (index >= greys_.size()) refuse_damaged_image(path_, "a colour beyond the palette");
      voxel = greys_[index];
    }
  }

 private:
  class ReadStruct {
   public:
    ReadStruct() = default;
    ~ReadStruct() { png_destroy_read_struct(&png_, &info_, nullptr); }
    ReadStruct(const ReadStruct&) = delete;
    ReadStruct& operator=(const ReadStruct&) = delete;
    void reset(png_structp png) { png_ = png; }
    png_infop make_info() { return info_ = png_create_info_struct(png_); }
    png_structp get() { return png_; }
    png_infop info() { return info_; }
    explicit operator bool() const { return png_ != nullptr; }

   private:
    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
  };

  [[noreturn]] static void fail(png_structp png, png_const_charp reason) {
    refuse_damaged_image(*static_cast<const std::string*>(png_get_error_ptr(png)), reason);
  }
  static void ignore(png_structp, png_const_charp) {}

  /// The values of a palette of greys; anything else that is not grey is refused.
  void prepare_greys() {
    const int type = png_get_color_type(png_.get(), png_.info());
    if (type == PNG_COLOR_TYPE_GRAY) return;
    if (type != PNG_COLOR_TYPE_PALETTE) refuse_color(path_);
    png_colorp colors = nullptr;
    int count = 0;
    png_get_PLTE(png_.get(), png_.info(), &colors, &count);
    for (int n = 0; n < count; ++n) {
      if (colors[n].red != colors[n].green || colors[n].red != colors[n].blue) refuse_color(path_);
      greys_.push_back(colors[n].red);
    }
    if (greys_.empty()) refuse_damaged_image(path_, "no palette");
  }

  std::string path_;
  CFile file_;
  ReadStruct png_;
  ImageShape shape_;
  std::vector<double> greys_;  // of the palette, if there is one
};

}  // namespace

std::unique_ptr<SliceImage> open_png_image(const std::string& path) {
  return std::make_unique<PngImage>(path);
}

}  // namespace stream_recon
