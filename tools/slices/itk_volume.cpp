#include "tools/slices/itk_volume.h"

#include <fmt/format.h>
#include <itkImageIOFactory.h>
#include <itkImageIOFactoryRegisterManager.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "io/error.h"
#include "tools/slices/metaimage_length.h"
#include "tools/slices/nifti_length.h"
#include "tools/slices/quiet_streams.h"

namespace stream_recon {
namespace {

constexpr std::size_t kSlabBytes = std::size_t{16} << 20;

/// The first line of ITK's description without the object's name and address.
std::string reason_of(const itk::ExceptionObject& e) {
  std::string reason = e.GetDescription();
  const std::size_t address = reason.find("): ");
  if (address != std::string::npos) reason.erase(0, address + 3);
  reason.erase(0, reason.find_first_not_of('\n'));
  reason.erase(std::min(reason.find('\n'), reason.size()));
  while (reason.ends_with(':') || reason.ends_with(' ')) reason.pop_back();
  return reason.empty() ? "no reason given" : reason;
}

/// Runs `read` and turns ITK's exceptions into ours.
template <typename Read>
void guarded(const std::string& path, Read read) {
  try {
    const QuietStreams quiet;
    read();
  } catch (const itk::ExceptionObject& e) {
    throw InputError(fmt::format("{}: ITK cannot read this volume ({}); check that it is complete",
                                 path, reason_of(e)));
  }
}

itk::ImageIOBase::Pointer open_reader(const std::string& path) {
  if (!std::filesystem::exists(path))
    throw InputError(fmt::format("{}: no such file; check the name", path));
  if (std::filesystem::is_directory(path))
    throw InputError(fmt::format("{}: a folder; name a single volume file", path));
  itk::ImageIOBase::Pointer reader;
  guarded(path, [&] {
    reader =
        itk::ImageIOFactory::CreateImageIO(path.c_str(), itk::CommonEnums::IOFileMode::ReadMode);
    if (!reader) return;
    reader->SetFileName(path);
    reader->ReadImageInformation();
  });
  if (!reader) {
    throw InputError(fmt::format(
        "{}: not a volume of a format that ITK reads, or it may not be opened; convert it to NIfTI",
        path));
  }
  return reader;
}

void refuse_unsuitable(const itk::ImageIOBase& reader, const std::string& path) {
  if (reader.GetNumberOfComponents() != 1) {
    throw InputError(fmt::format("{}: {} values a voxel; extract one component first", path,
                                 reader.GetNumberOfComponents()));
  }
  for (unsigned d = 0; d < reader.GetNumberOfDimensions(); ++d) {
    if (reader.GetDimensions(d) == 0) {
      throw InputError(fmt::format("{}: a volume without voxels; check the file", path));
    }
    if (d < 3 || reader.GetDimensions(d) == 1) continue;
    throw InputError(fmt::format("{}: {} dimensions; extract one volume of the series first", path,
                                 reader.GetNumberOfDimensions()));
  }
}

/// For the formats whose ITK reader takes a truncated file for a complete one.
void check_length(const itk::ImageIOBase& reader, const std::string& path) {
  const std::string format = reader.GetNameOfClass();
  if (format == "NiftiImageIO") check_nifti_length(path);
  if (format == "MetaImageIO") check_metaimage_length(path);
}

VolumeGeometry geometry_of(const itk::ImageIOBase& reader) {
  VolumeGeometry geometry;
  geometry.size = {1, 1, 1};
  geometry.step = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  double origin[3] = {0, 0, 0};
  const unsigned dimensions = std::min(3U, reader.GetNumberOfDimensions());
  for (unsigned d = 0; d < dimensions; ++d) {
    geometry.size[d] = reader.GetDimensions(d);
    origin[d] = reader.GetOrigin(d);
    std::vector<double> axis = reader.GetDirection(d);
    axis.resize(3, 0);
    const double spacing = reader.GetSpacing(d);
    geometry.step[d] = {axis[0] * spacing, axis[1] * spacing, axis[2] * spacing};
  }
  geometry.origin = {origin[0], origin[1], origin[2]};
  return geometry;
}

template <typename Voxel>
void widen(const std::byte* bytes, std::span<double> out) {
  const auto* voxels = reinterpret_cast<const Voxel*>(bytes);
  std::copy(voxels, voxels + out.size(), out.begin());
}

/// The conversion of voxels to double; null for an unknown type.
using Widener = void (*)(const std::byte*, std::span<double>);
Widener widener_of(itk::IOComponentEnum type) {
  switch (type) {
    case itk::IOComponentEnum::UCHAR:
      return widen<unsigned char>;
    case itk::IOComponentEnum::CHAR:
      return widen<signed char>;
    case itk::IOComponentEnum::USHORT:
      return widen<unsigned short>;
    case itk::IOComponentEnum::SHORT:
      return widen<short>;
    case itk::IOComponentEnum::UINT:
      return widen<unsigned int>;
    case itk::IOComponentEnum::INT:
      return widen<int>;
    case itk::IOComponentEnum::ULONG:
      return widen<unsigned long>;
    case itk::IOComponentEnum::LONG:
      return widen<long>;
    case itk::IOComponentEnum::ULONGLONG:
      return widen<unsigned long long>;
    case itk::IOComponentEnum::LONGLONG:
      return widen<long long>;
    case itk::IOComponentEnum::FLOAT:
      return widen<float>;
    case itk::IOComponentEnum::DOUBLE:
      return widen<double>;
    default:
      return nullptr;
  }
}

class ItkVolume : public Volume {
 public:
  explicit ItkVolume(const std::string& path) : path_(path), reader_(open_reader(path)) {
    refuse_unsuitable(*reader_, path);
    check_length(*reader_, path);
    widener_ = widener_of(reader_->GetComponentType());
    if (widener_ == nullptr) {
      throw InputError(
          fmt::format("{}: unknown type of voxel; convert it to short or float", path));
    }
    geometry_ = geometry_of(*reader_);
    slice_bytes_ = geometry_.size[0] * geometry_.size[1] * reader_->GetComponentSize();
    slab_slices_ = reader_->CanStreamRead() ? std::max<std::size_t>(1, kSlabBytes / slice_bytes_)
                                            : geometry_.size[2];
  }

  const VolumeGeometry& geometry() const override { return geometry_; }

  void read_slice(std::size_t k, std::span<double> out) override {
    if (k < first_ || k >= last_) read_slab(k);
    widener_(slab_.data() + (k - first_) * slice_bytes_, out);
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
    guarded(path_, [&] {
      reader_->SetIORegion(region);
      reader_->Read(slab_.data());
    });
    const auto voxel = static_cast<std::ptrdiff_t>(reader_->GetComponentSize());
    return std::find(slab_.end() - voxel, slab_.end(), before) != slab_.end();
  }

  std::string path_;
  itk::ImageIOBase::Pointer reader_;
  Widener widener_ = nullptr;
  VolumeGeometry geometry_;
  std::size_t slice_bytes_ = 0, slab_slices_ = 0;
  std::size_t first_ = 0, last_ = 0;  // slices in the slab
  std::vector<std::byte> slab_;
};

}  // namespace

std::unique_ptr<Volume> open_itk_volume(const std::string& path) {
  return std::make_unique<ItkVolume>(path);
}

}  // namespace stream_recon
