#include "tools/slices/open_volume.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "io/error.h"
#include "spatial/vector.h"
#include "tools/slices/dicom_header.h"
#include "tools/slices/dicom_series.h"
#include "tools/slices/image_stack.h"
#include "tools/slices/raw_volume.h"
#include "tools/slices/unpacked_file.h"
#include "tools/slices/volume_file.h"
#include "tools/slices/volume_folder.h"

namespace stream_recon {
namespace {

using Paths = std::vector<std::string>;

/// A volume whose voxels lie closer or wider than its file says.
class RespacedVolume : public Volume {
 public:
  RespacedVolume(std::unique_ptr<Volume> volume, const std::array<double, 3>& spacing)
      : volume_(std::move(volume)), geometry_(volume_->geometry()) {
    const std::array<Point3, 3> units{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    for (std::size_t d = 0; d < 3; ++d) {
      Point3& step = geometry_.step[d];
      const double before = length(step);
      step = scaled(before > 0 ? step : units[d], spacing[d] / (before > 0 ? before : 1));
    }
    geometry_.has_spacing = true;
  }

  const VolumeGeometry& geometry() const override { return geometry_; }
  std::string source() const override { return volume_->source(); }
  void read_slice(std::size_t k, std::span<double> out) override { volume_->read_slice(k, out); }

 private:
  std::unique_ptr<Volume> volume_;
  VolumeGeometry geometry_;
};

void check(const VolumeRequest& request) {
  if (request.paths.empty()) throw std::invalid_argument("no volume is named; name a file");
  if (request.raw && !request.series.empty())
    throw std::invalid_argument("a series is chosen among DICOM files, not among raw ones");
  if (!request.spacing) return;
  for (const double length : *request.spacing) {
    if (!std::isfinite(length) || length <= 0)
      throw std::invalid_argument("the spacing must be three finite numbers above 0");
  }
}

void check_files(const Paths& paths) {
  for (const std::string& path : paths) {
    if (!std::filesystem::is_directory(path)) {
      length_of_file(path);
    } else if (paths.size() > 1) {
      throw InputError(fmt::format("{}: a folder among files; name it alone", path));
    }
  }
}

void check_no_series(const VolumeRequest& request) {
  if (request.series.empty()) return;
  throw InputError(
      fmt::format("{}: not DICOM, so it has no series; leave --series out", request.paths.front()));
}

std::unique_ptr<Volume> open_folder(const VolumeRequest& request) {
  const std::string& folder = request.paths.front();
  if (request.raw) return open_raw_volume(raw_files_in_folder(folder), *request.raw);
  const FolderSlices slices = slices_in_folder(folder);
  if (!slices.kind) return open_dicom_series({folder, slices.paths, request.series});
  check_no_series(request);
  return open_image_stack(*slices.kind, slices.paths);
}

std::unique_ptr<Volume> open_files(const VolumeRequest& request) {
  const Paths& paths = request.paths;
  if (request.raw) return open_raw_volume(paths, *request.raw);
  if (is_dicom(paths.front())) {
    for (const std::string& path : paths) {
      if (is_dicom(path)) continue;
      throw InputError(
          fmt::format("{}: not DICOM like {}, or cut off; copy it again", path, paths.front()));
    }
    return open_dicom_series({paths.front(), paths, request.series});
  }
  check_no_series(request);
  if (const auto kind = image_kind_of(paths.front())) return open_image_stack(*kind, paths);
  if (is_named_as_image(paths.front())) refuse_unknown_image(paths.front());
  if (paths.size() == 1) return open_volume_file(paths.front());
  throw InputError(
      fmt::format("{}: one of {} files, but no PNG, TIFF, JPEG, BMP or DICOM slice; "
                  "name a single volume",
                  paths.front(), paths.size()));
}

// More than a damaged header asks for by chance; such a slice takes 8 GiB.
constexpr double kMostSliceVoxels = 1 << 30;

void check_size(const Volume& volume, const std::string& name) {
  const auto& size = volume.geometry().size;
  if (static_cast<double>(size[0]) * static_cast<double>(size[1]) <= kMostSliceVoxels) return;
  throw InputError(fmt::format("{}: slices of {} x {} voxels are too large; check its header", name,
                               size[0], size[1]));
}

}  // namespace

std::unique_ptr<Volume> open_volume(const VolumeRequest& request) {
  check(request);
  check_files(request.paths);
  const std::string& name = request.paths.front();
  auto volume = std::filesystem::is_directory(name) ? open_folder(request) : open_files(request);
  check_size(*volume, name);
  if (request.spacing) return std::make_unique<RespacedVolume>(std::move(volume), *request.spacing);
  if (request.needs_spacing && !volume->geometry().has_spacing) {
    throw InputError(
        fmt::format("{}: the distance of its voxels is not known; give it with "
                    "--spacing X,Y,Z",
                    name));
  }
  return volume;
}

}  // namespace stream_recon
