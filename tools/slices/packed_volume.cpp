#include "tools/slices/packed_volume.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "io/error.h"

namespace stream_recon {
namespace {

/// \throw InputError more bytes than 64 bits count
std::uint64_t volume_bytes(const VolumeGeometry& geometry, RawType type, const std::string& path) {
  std::uint64_t bytes = scalar_size(type);
  for (const std::size_t n : geometry.size) {
    if (n != 0 && bytes > std::numeric_limits<std::uint64_t>::max() / 4 / n)
      throw InputError(fmt::format("{}: more voxels than a file can hold; check the header", path));
    bytes *= n;
  }
  return bytes;
}

class PackedVolume : public Volume {
 public:
  PackedVolume(VoxelLayout layout, const VolumeGeometry& geometry, std::string source)
      : layout_(std::move(layout)), geometry_(geometry), source_(std::move(source)) {
    const std::uint64_t bytes = volume_bytes(geometry_, layout_.format.type, layout_.files.front());
    if (bytes % layout_.files.size() != 0) {
      throw InputError(
          fmt::format("{}: {} bytes of voxels cannot lie in {} equal files; check the"
                      " number of files",
                      layout_.files.front(), bytes, layout_.files.size()));
    }
    file_bytes_ = bytes / layout_.files.size();
    for (const std::string& path : layout_.files) check_length(path);
    slice_bytes_ = geometry_.size[0] * geometry_.size[1] * scalar_size(layout_.format.type);
  }

  const VolumeGeometry& geometry() const override { return geometry_; }
  std::string source() const override { return source_; }

  void read_slice(std::size_t k, std::span<double> out) override {
    bytes_.resize(slice_bytes_);
    read_bytes(std::uint64_t{k} * slice_bytes_, bytes_);
    widen_voxels(bytes_.data(), layout_.format, out);
    rescale(out);
  }

 private:
  void check_length(const std::string& path) const {
    const std::uint64_t length = length_of_file(path);
    if (layout_.packing != Packing::kNone) return;
    const std::uint64_t wanted = (layout_.at_end ? 0 : layout_.start) + file_bytes_;
    if (length < wanted) {
      throw InputError(
          fmt::format("{}: {} bytes instead of {}; copy the file again", path, length, wanted));
    }
    if (layout_.exact_length && length != wanted) {
      throw InputError(fmt::format("{}: {} bytes instead of {}; check dimensions, type and skip",
                                   path, length, wanted));
    }
  }

  void read_bytes(std::uint64_t at, std::span<std::byte> out) {
    while (!out.empty()) {
      const std::uint64_t in_file = at % file_bytes_;
      open_at(at / file_bytes_, in_file);
      const std::size_t part = std::min<std::uint64_t>(out.size(), file_bytes_ - in_file);
      if (file_->read(out.first(part)) < part) fail_short();
      if (in_file + part == file_bytes_) file_->finish();
      out = out.subspan(part);
      at += part;
    }
  }

  void open_at(std::size_t index, std::uint64_t offset) {
    const std::string& path = layout_.files[index];
    const std::uint64_t wanted = layout_.unpacked_skip + offset;
    if (!file_ || index != index_ || file_->position() > wanted) {
      file_.reset();
      const std::uint64_t start =
          layout_.at_end ? length_of_file(path) - file_bytes_ : layout_.start;
      file_ = std::make_unique<UnpackedFile>(path, layout_.packing, start);
      index_ = index;
    }
    const std::uint64_t ahead = wanted - file_->position();
    if (ahead > 0 && file_->skip(ahead) < ahead) fail_short();
  }

  [[noreturn]] void fail_short() const {
    throw InputError(fmt::format("{}: ends after {} of {} unpacked bytes; copy the file again",
                                 layout_.files[index_], file_->position(),
                                 layout_.unpacked_skip + file_bytes_));
  }

  void rescale(std::span<double> values) const {
    if (layout_.slope == 1 && layout_.intercept == 0) return;
    if (layout_.rounds_to_float) {
      for (double& v : values)
        v = static_cast<float>(static_cast<float>(v) * layout_.slope + layout_.intercept);
    } else {
      for (double& v : values) v = v * layout_.slope + layout_.intercept;
    }
  }

  VoxelLayout layout_;
  VolumeGeometry geometry_;
  std::string source_;
  std::uint64_t file_bytes_ = 0;
  std::size_t slice_bytes_ = 0;
  std::vector<std::byte> bytes_;
  std::unique_ptr<UnpackedFile> file_;
  std::size_t index_ = 0;  // of the open file
};

}  // namespace

std::unique_ptr<Volume> open_packed_volume(VoxelLayout layout, const VolumeGeometry& geometry,
                                           const std::string& source) {
  return std::make_unique<PackedVolume>(std::move(layout), geometry, source);
}

}  // namespace stream_recon
