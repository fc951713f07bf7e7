#include "engine/disk_estimate.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/size_text.h"
#include "io/folder.h"

namespace stream_recon {
namespace {

// Bytes a point, compressed.
constexpr std::uint64_t kOrdering = 75;  // spool, sorted runs and store side by side
constexpr std::uint64_t kStoreAndIndex = 27;
constexpr std::uint64_t kFacets = 30;
constexpr std::uint64_t kTetrahedra = 65;
constexpr std::uint64_t kSurfaceOutput = 55;
constexpr std::uint64_t kTetrahedraOutput = 90;
constexpr std::uint64_t kPoles = 320;  // exports, sorted runs and the store side by side
constexpr std::uint64_t kPolesOutput = 90;
constexpr std::uint64_t kCrust = 650;  // corners and triangles, two sorts, store and facets
constexpr std::uint64_t kCrustOutput = 500;
constexpr std::uint64_t kHoles = 120;  // fills and samples of holes, and the crust near them
constexpr std::uint64_t kShape = 60;
constexpr std::uint64_t kShapeOutput = 40;

bool has_surface(const RunOptions& options) {
  return options.surface != SurfaceKind::kNone;
}

bool is_crust(const RunOptions& options) {
  return options.surface == SurfaceKind::kCrust;
}

/// Where the outputs are written; empty if to standard output or nowhere.
std::string output_folder(const RunOptions& options) {
  if (has_surface(options) && options.output != "-") return parent_folder(options.output);
  if (!options.tetrahedra.empty()) return parent_folder(options.tetrahedra);
  return options.medial_axis.empty() ? "" : parent_folder(options.medial_axis);
}

}  // namespace

DiskEstimate estimate_disk(std::uint64_t points, const RunOptions& options) {
  const bool has_tetrahedra = !options.tetrahedra.empty();
  const bool has_axis = !options.medial_axis.empty();
  const std::uint64_t surface_output = is_crust(options) ? kCrustOutput : kSurfaceOutput;
  std::uint64_t windows = kStoreAndIndex;
  if (has_surface(options) || has_axis) windows += kFacets;
  if (options.needs_poles()) windows += kPoles;
  if (is_crust(options)) windows += kCrust;
  if (options.surface == SurfaceKind::kHybrid) windows += kHoles;
  if (options.medial_axis_faces) windows += kShape;
  if (has_tetrahedra) windows += kTetrahedra;
  // A single file is put together from parts in scratch.
  if (has_surface(options) && !options.output.ends_with(".pvtp")) windows += surface_output;
  std::uint64_t outputs = 0;
  if (has_surface(options) && options.output != "-") outputs += surface_output;
  if (has_tetrahedra) outputs += kTetrahedraOutput;
  if (has_axis) outputs += kPolesOutput;
  if (options.medial_axis_faces) outputs += kShapeOutput;
  return {points * std::max(kOrdering, windows), points * outputs};
}

DiskOutlook disk_outlook(const DiskEstimate& estimate, const RunOptions& options,
                         std::uint64_t scratch_bytes) {
  const std::string scratch_folder = options.scratch_parent();
  const std::string folder = output_folder(options);
  const std::uint64_t scratch = estimate.scratch - std::min(estimate.scratch, scratch_bytes);
  const bool is_one_disk = !folder.empty() && are_on_one_disk(scratch_folder, folder);
  const std::uint64_t free = free_bytes(scratch_folder);

  DiskOutlook outlook;
  outlook.text = fmt::format("disk: about {} for scratch", size_text(scratch));
  if (!folder.empty())
    outlook.text += fmt::format(" and {} for output", size_text(estimate.outputs));
  outlook.text += fmt::format(", {} free in {}", size_text(free), scratch_folder);
  outlook.is_short = scratch + (is_one_disk ? estimate.outputs : 0) > free ||
                     estimate.scratch > options.scratch_limit_bytes;
  if (!folder.empty() && !is_one_disk) {
    const std::uint64_t beside = free_bytes(folder);
    outlook.text += fmt::format(", {} in {}", size_text(beside), folder);
    outlook.is_short = outlook.is_short || estimate.outputs > beside;
  }
  if (options.scratch_limit_bytes < estimate.scratch) {
    outlook.text += fmt::format(", --scratch-limit is {}", size_text(options.scratch_limit_bytes));
  }
  return outlook;
}

}  // namespace stream_recon
