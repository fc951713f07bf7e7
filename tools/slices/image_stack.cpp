#include "tools/slices/image_stack.h"

#include <fmt/format.h>

#include "io/error.h"
#include "tools/slices/packed_volume.h"
#include "tools/slices/tiff_pages.h"

namespace stream_recon {
namespace {

VolumeGeometry unknown_spacing(const ImageShape& shape, std::size_t slices) {
  VolumeGeometry geometry;
  geometry.size = {shape.width, shape.height, slices};
  geometry.step = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  geometry.has_spacing = false;
  return geometry;
}

class TiffImage : public SliceImage {
 public:
  explicit TiffImage(const std::string& path) : pages_(path), shape_(pages_.open(0)) {
    if (pages_.size() == 1 && pages_.undescribed_pages() == 0) return;
    throw InputError(fmt::format("{}: one of several files, but itself has {} pages; name it alone",
                                 path, std::max(pages_.size(), pages_.undescribed_pages())));
  }

  const ImageShape& shape() const override { return shape_; }
  void read(std::span<double> out) override { pages_.read(out); }

 private:
  TiffPages pages_;
  ImageShape shape_;
};

std::unique_ptr<SliceImage> open_image(ImageKind kind, const std::string& path) {
  if (image_kind_of(path) != kind) {
    throw InputError(fmt::format(
        "{}: not a {} like the other slices, or cut off; convert or copy it", path, name_of(kind)));
  }
  switch (kind) {
    case ImageKind::kPng:
      return open_png_image(path);
    case ImageKind::kJpeg:
      return open_jpeg_image(path);
    case ImageKind::kBmp:
      return open_bmp_image(path);
    case ImageKind::kTiff:
      break;
  }
  return std::make_unique<TiffImage>(path);
}

class ImageStack : public Volume {
 public:
  ImageStack(ImageKind kind, const std::vector<std::string>& paths) : kind_(kind), paths_(paths) {
    shape_ = open_image(kind, paths.front())->shape();
    for (const std::string& path : paths) check(path, *open_image(kind, path));
    geometry_ = unknown_spacing(shape_, paths.size());
  }

  const VolumeGeometry& geometry() const override { return geometry_; }
  std::string source() const override {
    return fmt::format("{} to {} ({})", paths_.front(), paths_.back(), name_of(kind_));
  }

  void read_slice(std::size_t k, std::span<double> out) override {
    const auto image = open_image(kind_, paths_[k]);
    check(paths_[k], *image);
    image->read(out);
  }

 private:
  void check(const std::string& path, const SliceImage& image) const {
    if (image.shape() == shape_) return;
    throw InputError(fmt::format("{}: {}, but {} is {}; all slices must be alike", path,
                                 described(image.shape()), paths_.front(), described(shape_)));
  }

  ImageKind kind_;
  std::vector<std::string> paths_;
  ImageShape shape_;
  VolumeGeometry geometry_;
};

class TiffStack : public Volume {
 public:
  explicit TiffStack(const std::string& path) : path_(path), pages_(path) {
    shape_ = pages_.open(0);
    for (std::size_t page = 1; page < pages_.size(); ++page) open(page);
    geometry_ = unknown_spacing(shape_, pages_.size());
  }

  const VolumeGeometry& geometry() const override { return geometry_; }
  std::string source() const override {
    return fmt::format("{} (TIFF of {} pages)", path_, pages_.size());
  }

  void read_slice(std::size_t k, std::span<double> out) override {
    open(k);
    pages_.read(out);
  }

 private:
  void open(std::size_t page) {
    const ImageShape shape = pages_.open(page);
    if (shape == shape_) return;
    throw InputError(fmt::format("{}: page {} is {}, but page 1 {}; all slices must be alike",
                                 path_, page + 1, described(shape), described(shape_)));
  }

  std::string path_;
  TiffPages pages_;
  ImageShape shape_;
  VolumeGeometry geometry_;
};

}  // namespace

std::unique_ptr<Volume> open_image_stack(ImageKind kind, const std::vector<std::string>& paths) {
  if (kind != ImageKind::kTiff || paths.size() > 1)
    return std::make_unique<ImageStack>(kind, paths);
  TiffPages first(paths.front());
  const ImageShape shape = first.open(0);
  const std::size_t undescribed = first.undescribed_pages();
  if (undescribed == 0) return std::make_unique<TiffStack>(paths.front());
  VoxelLayout layout;
  layout.files = paths;
  layout.format = {shape.type, first.byte_order()};
  layout.start = first.start_of_plain_pixels();
  return open_packed_volume(layout, unknown_spacing(shape, undescribed), paths.front());
}

}  // namespace stream_recon
