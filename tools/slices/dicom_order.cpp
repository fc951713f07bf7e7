#include "tools/slices/dicom_order.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/error.h"
#include "spatial/vector.h"

namespace stream_recon {
namespace {

constexpr double kSamePlace = 1e-3;  // mm
constexpr double kUneven = 0.03;     // of the usual distance
constexpr double kAxisError = 1e-3;  // of a unit vector
constexpr double kOffRow = 0.5;      // of the distance of slices

void check_complete(const DicomHeader& slice) {
  if (slice.frames > 1) {
    throw InputError(
        fmt::format("{}: {} frames, and there are other files of its series; name it "
                    "alone",
                    slice.path, slice.frames));
  }
  if (!slice.position || !slice.axes) {
    throw InputError(
        fmt::format("{}: no ImagePositionPatient or no ImageOrientationPatient; leave "
                    "the file out",
                    slice.path));
  }
}

void check_alike(const DicomHeader& slice, const DicomHeader& first) {
  if (slice.rows != first.rows || slice.columns != first.columns) {
    throw InputError(fmt::format("{}: {} x {} voxels, but {} has {} x {}; leave the file out",
                                 slice.path, slice.columns, slice.rows, first.path, first.columns,
                                 first.rows));
  }
  for (std::size_t n = 0; n < 2; ++n) {
    if (length(minus((*slice.axes)[n], (*first.axes)[n])) > kAxisError) {
      throw InputError(fmt::format("{}: another orientation than {}; leave the file out",
                                   slice.path, first.path));
    }
    if (slice.pixel_spacing.has_value() == first.pixel_spacing.has_value() &&
        (!slice.pixel_spacing || std::abs((*slice.pixel_spacing)[n] - (*first.pixel_spacing)[n]) <=
                                     kAxisError * (*first.pixel_spacing)[n]))
      continue;
    throw InputError(fmt::format("{}: another spacing of pixels than {}; leave the file out",
                                 slice.path, first.path));
  }
}

/// Distances from each slice to the next, along the normal.
std::vector<double> distances(const std::vector<DicomHeader>& slices, const Point3& normal) {
  std::vector<double> all;
  for (std::size_t k = 1; k < slices.size(); ++k) {
    const double gap = dot(minus(*slices[k].position, *slices[k - 1].position), normal);
    all.push_back(gap);
    if (gap > kSamePlace) continue;
    throw InputError(
        fmt::format("{}: at the place of {} ({:.3f} mm along the normal); leave one of "
                    "them out",
                    slices[k].path, slices[k - 1].path, dot(*slices[k].position, normal)));
  }
  return all;
}

void check_even(const std::vector<DicomHeader>& slices, const std::vector<double>& gaps) {
  std::vector<double> sorted = gaps;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>((sorted.size() - 1) / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  for (std::size_t k = 0; k < gaps.size(); ++k) {
    if (std::abs(gaps[k] - *middle) <= kUneven * *middle) continue;
    throw InputError(fmt::format("{}: {:.3f} mm behind {}, but slices are {:.3f} mm apart; {}",
                                 slices[k + 1].path, gaps[k], slices[k].path, *middle,
                                 gaps[k] > 1.5 * *middle ? "a slice is missing between them"
                                                         : "resample the series evenly"));
  }
}

void check_in_row(const std::vector<DicomHeader>& slices, const Point3& step) {
  for (std::size_t k = 0; k < slices.size(); ++k) {
    const Point3 offset = minus(*slices[k].position, *slices[0].position);
    if (length(minus(offset, scaled(step, static_cast<double>(k)))) <= kOffRow * length(step))
      continue;
    throw InputError(
        fmt::format("{}: not in a straight row with the slices from {} to {}; leave "
                    "the file out",
                    slices[k].path, slices.front().path, slices.back().path));
  }
}

}  // namespace

DicomOrder order_dicom_slices(std::vector<DicomHeader> slices) {
  for (const DicomHeader& slice : slices) check_complete(slice);
  const auto axes = *slices.front().axes;
  for (const DicomHeader& slice : slices) check_alike(slice, slices.front());
  const Point3 normal = cross(axes[0], axes[1]);
  std::stable_sort(slices.begin(), slices.end(), [&](const DicomHeader& a, const DicomHeader& b) {
    return dot(*a.position, normal) < dot(*b.position, normal);
  });
  check_even(slices, distances(slices, normal));
  const Point3 step = scaled(minus(*slices.back().position, *slices.front().position),
                             1.0 / static_cast<double>(slices.size() - 1));
  check_in_row(slices, step);

  DicomOrder order;
  VolumeGeometry& geometry = order.geometry;
  geometry.size = {slices[0].columns, slices[0].rows, slices.size()};
  geometry.origin = *slices[0].position;
  geometry.has_spacing = slices[0].pixel_spacing.has_value();
  const auto spacing = slices[0].pixel_spacing.value_or(std::array{1.0, 1.0});
  geometry.step = {scaled(axes[0], spacing[0]), scaled(axes[1], spacing[1]), step};
  for (const DicomHeader& slice : slices) order.paths.push_back(slice.path);
  return order;
}

}  // namespace stream_recon
