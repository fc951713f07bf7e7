#include "tools/slices/volume_file.h"

#include <array>
#include <string_view>

#include "tools/slices/itk_file.h"
#include "tools/slices/itk_volume.h"
#include "tools/slices/volume_headers.h"

namespace stream_recon {
namespace {

VolumeHeader header_of(const ItkFile& file) {
  const std::string format = file.reader->GetNameOfClass();
  if (format == "NiftiImageIO") return read_nifti_header(file.path);
  if (format == "NrrdImageIO") return read_nrrd_header(file.path);
  if (format == "MetaImageIO") return read_metaimage_header(file.path);
  return {};
}

/// A NRRD header that ITK would refuse: without a word about which file is missing, or for its
/// axes.
std::unique_ptr<Volume> open_nrrd_without_itk(const std::string& path) {
  std::array<char, 4> magic{};
  UnpackedFile(path, Packing::kNone, 0).read(std::as_writable_bytes(std::span(magic)));
  if (std::string_view(magic.data(), magic.size()) != "NRRD") return nullptr;
  VolumeHeader header = read_nrrd_header(path);
  if (!header.layout) return nullptr;
  for (const std::string& file : header.layout->files) length_of_file(file);
  if (!header.geometry) return nullptr;
  header.geometry->has_spacing = header.has_spacing;
  return open_packed_volume(std::move(*header.layout), *header.geometry, path);
}

}  // namespace

std::unique_ptr<Volume> open_volume_file(const std::string& path) {
  if (auto volume = open_nrrd_without_itk(path)) return volume;
  ItkFile file = open_itk_file(path);
  VolumeHeader header = header_of(file);
  file.geometry.has_spacing = header.has_spacing;
  if (!header.layout) return open_itk_volume(std::move(file));
  header.layout->rounds_to_float = file.reader->GetComponentType() == itk::IOComponentEnum::FLOAT;
  return open_packed_volume(std::move(*header.layout), file.geometry, path);
}

}  // namespace stream_recon
