#include "tools/slices/volume_file.h"

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

}  // namespace

std::unique_ptr<Volume> open_volume_file(const std::string& path) {
  ItkFile file = open_itk_file(path);
  VolumeHeader header = header_of(file);
  file.geometry.has_spacing = header.has_spacing;
  if (!header.layout) return open_itk_volume(std::move(file));
  header.layout->rounds_to_float = file.reader->GetComponentType() == itk::IOComponentEnum::FLOAT;
  return open_packed_volume(std::move(*header.layout), file.geometry, path);
}

}  // namespace stream_recon
