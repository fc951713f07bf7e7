#include "tools/slices/itk_file.h"

#include <fmt/format.h>
#include <itkImageIOFactoryRegisterManager.h>
#include <itkObjectFactoryBase.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <new>
#include <vector>

#include "io/error.h"
#include "tools/slices/quiet_streams.h"

namespace stream_recon {
namespace {

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

/// Pictures have readers of their own here; ITK's for JPEG crashes on a file of two bytes.
bool is_for_pictures(const itk::ImageIOBase& reader) {
  const std::string name = reader.GetNameOfClass();
  return name == "BMPImageIO" || name == "JPEGImageIO" || name == "JPEG2000ImageIO" ||
         name == "LSMImageIO" || name == "PNGImageIO" || name == "TIFFImageIO";
}

itk::ImageIOBase::Pointer find_reader(const std::string& path) {
  if (!std::filesystem::exists(path))
    throw InputError(fmt::format("{}: no such file; check the name", path));
  if (std::filesystem::is_directory(path))
    throw InputError(fmt::format("{}: a folder; name a single volume file", path));
  itk::ImageIOBase::Pointer reader;
  call_itk(path, [&] {
    for (const auto& object : itk::ObjectFactoryBase::CreateAllInstance("itkImageIOBase")) {
      auto* candidate = dynamic_cast<itk::ImageIOBase*>(object.GetPointer());
      if (candidate == nullptr || is_for_pictures(*candidate)) continue;
      if (candidate->CanReadFile(path.c_str())) {
        reader = candidate;
        return;
      }
    }
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

}  // namespace

void call_itk(const std::string& path, const std::function<void()>& work) {
  std::string reason;
  try {
    const QuietStreams quiet;
    work();
    return;
  } catch (const itk::ExceptionObject& e) {
    reason = reason_of(e);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& e) {
    reason = e.what();
  }
  throw InputError(
      fmt::format("{}: ITK cannot read this volume ({}); check that it is complete", path, reason));
}

ItkFile open_itk_file(const std::string& path) {
  return open_itk_file(path, find_reader(path));
}

ItkFile open_itk_file(const std::string& path, itk::ImageIOBase::Pointer reader) {
  call_itk(path, [&] {
    reader->SetFileName(path);
    reader->ReadImageInformation();
  });
  refuse_unsuitable(*reader, path);
  return {path, reader, geometry_of(*reader)};
}

}  // namespace stream_recon
