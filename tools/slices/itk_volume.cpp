#include "tools/slices/itk_volume.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "io/error.h"
#include "tools/slices/voxel_bytes.h"

namespace stream_recon {
namespace {

constexpr std::size_t kSlabBytes = std::size_t{16} << 20;

std::optional<RawType> type_of(itk::IOComponentEnum type) {
  switch (type) {
    case itk::IOComponentEnum::UCHAR:
      return RawType::kUint8;
    case itk::IOComponentEnum::CHAR:
      return RawType::kInt8;
    case itk::IOComponentEnum::USHORT:
      return RawType::kUint16;
    case itk::IOComponentEnum::SHORT:
      return RawType::kInt16;
    case itk::IOComponentEnum::UINT:
      return RawType::kUint32;
    case itk::IOComponentEnum::INT:
      return RawType::kInt32;
    case itk::IOComponentEnum::ULONG:
      return sizeof(unsigned long) == 8 ? RawType::kUint64 : RawType::kUint32;
    case itk::IOComponentEnum::LONG:
      return sizeof(long) == 8 ? RawType::kInt64 : RawType::kInt32;
    case itk::IOComponentEnum::ULONGLONG:
      return RawType::kUint64;
    case itk::IOComponentEnum::LONGLONG:
      return RawType::kInt64;
    case itk::IOComponentEnum::FLOAT:
      return RawType::kFloat32;
    case itk::IOComponentEnum::DOUBLE:
      return RawType::kFloat64;
    default:
      return std::nullopt;
  }
}

class ItkVolume : public Volume {
 public:
  explicit ItkVolume(ItkFile file)
      : path_(std::move(file.path)), reader_(file.reader), geometry_(file.geometry) {
    const auto type = type_of(reader_->GetComponentType());
    if (!type) {
      throw InputError(
          fmt::format("{}: unknown type of voxel; convert it to short or float", path_));
    }
    format_ = {*type, std::endian::native};
    slice_bytes_ = geometry_.size[0] * geometry_.size[1] * reader_->GetComponentSize();
    slab_slices_ = reader_->CanStreamRead() ? std::max<std::size_t>(1, kSlabBytes / slice_bytes_)
                                            : geometry_.size[2];
  }

  const VolumeGeometry& geometry() const override { return geometry_; }
  std::string source() const override { return path_; }

  void read_slice(std::size_t k, std::span<double> out) override {
    if (k < first_ || k >= last_) read_slab(k);
    widen_voxels(slab_.data() + (k - first_) * slice_bytes_, format_, out);
  }

 private:
  void read_slab(std::size_t k) {
    const std::size_t first = k / slab_slices_ * slab_slices_;
    const std::size_t count = std::min(slab_slices_, geometry_.size[2] - first);
    const unsigned dimensions = reader_->GetNumberOfDimensions();
    itk::ImageIORegion region(dimensions);
    for (unsigned d = 0; d < dimensions; ++d) region.SetSize(d, reader_->GetDimensions(d));
    if (dimensions > 2) {
      region.SetIndex(2, static_cast<long>(first));
      region.SetSize(2, count);
    }
    slab_.resize(count * slice_bytes_);
    if (leaves(std::byte{0xa5}, region) && leaves(std::byte{0x5a}, region)) {
      throw InputError(fmt::format("{}: ends within slices {} to {}; copy the file again", path_,
                                   first, first + count - 1));
    }
    first_ = first;
    last_ = first + count;
  }

  /// Reads the slab; is a byte of its last voxel still what was there before? Some of ITK's
  /// readers leave what a truncated file does not have, and say nothing.
  bool leaves(std::byte before, const itk::ImageIORegion& region) {
    std::fill(slab_.begin(), slab_.end(), before);
    call_itk(path_, [&] {
      reader_->SetIORegion(region);
      reader_->Read(slab_.data());
    });
    const auto voxel = static_cast<std::ptrdiff_t>(reader_->GetComponentSize());
    return std::find(slab_.end() - voxel, slab_.end(), before) != slab_.end();
  }

  std::string path_;
  itk::ImageIOBase::Pointer reader_;
  VoxelFormat format_;
  VolumeGeometry geometry_;
  std::size_t slice_bytes_ = 0, slab_slices_ = 0;
  std::size_t first_ = 0, last_ = 0;  // slices in the slab
  std::vector<std::byte> slab_;
};

}  // namespace

std::unique_ptr<Volume> open_itk_volume(ItkFile file) {
  return std::make_unique<ItkVolume>(std::move(file));
}

}  // namespace stream_recon
