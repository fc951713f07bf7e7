#include "tools/slices/dicom_series.h"

#include <fmt/format.h>
#include <itkGDCMImageIO.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "io/error.h"
#include "tools/slices/dicom_header.h"
#include "tools/slices/dicom_order.h"
#include "tools/slices/itk_volume.h"
#include "tools/slices/volume_file.h"

namespace stream_recon {
namespace {

using Series = std::map<std::string, std::vector<DicomHeader>>;

Series series_of(const DicomFiles& files) {
  Series all;
  std::vector<DicomHeader> without_image;
  for (const std::string& path : files.paths) {
    DicomHeader header = read_dicom_header(path);
    if (header.is_directory) continue;
    const bool is_image = header.rows > 0 && header.columns > 0;
    (is_image ? all[header.series] : without_image).push_back(std::move(header));
  }
  // Reports and the like have series of their own.
  for (const DicomHeader& header : without_image) {
    if (!header.series.empty() && !all.contains(header.series)) continue;
    throw InputError(fmt::format("{}: a DICOM file that ends before its image; copy the file again",
                                 header.path));
  }
  if (all.empty())
    throw InputError(fmt::format("{}: no DICOM image among the files; check the name", files.name));
  return all;
}

std::string listed(const Series& all) {
  std::string text;
  for (const auto& [uid, slices] : all) {
    const std::size_t number = static_cast<std::size_t>(std::distance(all.begin(), all.find(uid)));
    text += fmt::format("{}{}: {} \"{}\" {} slice{}", text.empty() ? "" : "; ", number + 1, uid,
                        slices.front().description, slices.size(), slices.size() == 1 ? "" : "s");
  }
  return text;
}

std::vector<DicomHeader> chosen(const Series& all, const DicomFiles& files) {
  if (files.series.empty()) {
    if (all.size() == 1) return all.begin()->second;
    throw InputError(fmt::format("{}: {} series, choose one with --series: {}", files.name,
                                 all.size(), listed(all)));
  }
  if (const auto exact = all.find(files.series); exact != all.end()) return exact->second;
  std::vector<Series::const_iterator> found;
  std::size_t number = 0;
  for (auto at = all.begin(); at != all.end(); ++at) {
    if (std::to_string(++number) == files.series) return at->second;
    if (at->first.ends_with(files.series)) found.push_back(at);
  }
  if (found.size() == 1) return found.front()->second;
  throw InputError(fmt::format("{}: --series {} fits {} of the series; there are {}", files.name,
                               files.series, found.empty() ? "none" : "several", listed(all)));
}

class DicomVolume : public Volume {
 public:
  explicit DicomVolume(DicomOrder order) : order_(std::move(order)) {}

  const VolumeGeometry& geometry() const override { return order_.geometry; }
  std::string source() const override {
    return fmt::format("{} to {} (DICOM)", order_.paths.front(), order_.paths.back());
  }

  void read_slice(std::size_t k, std::span<double> out) override {
    const auto slice = open_itk_volume(open_itk_file(order_.paths[k], itk::GDCMImageIO::New()));
    const auto& size = slice->geometry().size;
    if (size[0] * size[1] * size[2] != out.size()) {
      throw InputError(
          fmt::format("{}: {} x {} x {} voxels, but its header says {} x {}; copy the "
                      "file again",
                      order_.paths[k], size[0], size[1], size[2], order_.geometry.size[0],
                      order_.geometry.size[1]));
    }
    slice->read_slice(0, out);
  }

 private:
  DicomOrder order_;
};

}  // namespace

std::unique_ptr<Volume> open_dicom_series(const DicomFiles& files) {
  std::vector<DicomHeader> slices = chosen(series_of(files), files);
  if (slices.size() == 1) return open_volume_file(slices.front().path);
  return std::make_unique<DicomVolume>(order_dicom_slices(std::move(slices)));
}

}  // namespace stream_recon
