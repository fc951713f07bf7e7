#include "engine/run_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string_view>
#include <system_error>

namespace stream_recon {
namespace {

/// Balls that are larger are no noise.
constexpr double kMostLeastBall = 100;

void require(bool holds, const std::string& message) {
  if (!holds) throw std::invalid_argument(message);
}

bool is_surface_path(std::string_view path) {
  return path == "-" || path.ends_with(".pvtp") || path.ends_with(".ply") || path.ends_with(".vtk");
}

void check_output(const RunOptions& options) {
  if (options.surface == SurfaceKind::kNone) return;
  require(!options.output.empty(), "no output: give -o OUT.pvtp, or --surface none");
  require(
      is_surface_path(options.output),
      fmt::format("-o {}: the name must end in .pvtp, .ply or .vtk, or be - for PLY on standard "
                  "output",
                  options.output));
}

/// The path that a chunked output has its folder at, or where a file stands.
std::filesystem::path place_of(std::string_view output) {
  if (output.ends_with(".pvtp") || output.ends_with(".pvtu")) output.remove_suffix(5);
  std::error_code error;
  const auto place = std::filesystem::current_path(error) / output;
  const auto canonical = std::filesystem::weakly_canonical(place, error);
  return error ? place : canonical;
}

/// Whether `place` is `folder` or lies in it.
bool is_within(const std::filesystem::path& place, const std::filesystem::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), place.begin(), place.end()).first ==
         folder.end();
}

/// Chunked outputs, and the surface, must not lie in each other's folders.
void require_apart(const char* option, const std::string& path, const char* other_option,
                   const std::string& other) {
  if (path.empty() || path == "-" || other.empty()) return;
  const auto one = place_of(path);
  const auto two = place_of(other);
  require(!is_within(one, two) && !is_within(two, one),
          fmt::format("{0} {1} and {2} {3} would use one folder for their chunks; "
                      "give {2} another name",
                      option, path, other_option, other));
}

/// Its far points would change the surfaces of other kinds.
void check_faces(const RunOptions& options) {
  if (!options.medial_axis_faces) return;
  require(!options.medial_axis.empty(),
          "--medial-axis-faces is for --medial-axis OUT.pvtp; add that or leave it out");
  const SurfaceKind kind = options.surface;
  require(kind == SurfaceKind::kCrust || kind == SurfaceKind::kNone,
          fmt::format("--medial-axis-faces needs far points, which --surface {} has not; use "
                      "--surface crust or none",
                      kind_name(kind)));
  require(options.medial_axis_side == PoleSide::kInner,
          fmt::format("--medial-axis-faces lie between inner balls, and --medial-axis-side is {}; "
                      "leave one of them out",
                      kPoleSideNames.at(static_cast<std::size_t>(options.medial_axis_side))));
}

void check_chunked(const RunOptions& options) {
  const std::string& tetrahedra = options.tetrahedra;
  const std::string& axis = options.medial_axis;
  require(tetrahedra.empty() || tetrahedra.ends_with(".pvtu"),
          fmt::format("--tetrahedra {}: the name must end in .pvtu", tetrahedra));
  require(axis.empty() || axis.ends_with(".pvtp"),
          fmt::format("--medial-axis {}: the name must end in .pvtp", axis));
  const SurfaceKind kind = options.surface;
  require(axis.empty() || (kind != SurfaceKind::kGamma && kind != SurfaceKind::kAlpha),
          fmt::format("--medial-axis needs an inside, and --surface {} has none; "
                      "use --surface solid, crust, hybrid or none",
                      kind_name(kind)));
  check_faces(options);
  const std::string surface = kind == SurfaceKind::kNone ? "" : options.output;
  require_apart("-o", surface, "--tetrahedra", tetrahedra);
  require_apart("-o", surface, "--medial-axis", axis);
  require_apart("--tetrahedra", tetrahedra, "--medial-axis", axis);
}

void check_unused(const RunOptions& options) {
  const std::string& path = options.unused;
  if (path.empty()) return;
  require(path.ends_with(".ply"), fmt::format("--unused {}: the name must end in .ply", path));
  require(options.surface != SurfaceKind::kNone,
          "--unused names the points that no triangle has, but --surface none makes no triangles; "
          "leave one of them out");
  require(options.surface != SurfaceKind::kCrust,
          "--unused names samples that no triangle has, and the crust has corners of its own; "
          "leave --unused out or use --surface solid");
  require(
      options.surface != SurfaceKind::kHybrid,
      "--unused is not made of the hybrid, whose cloud has far points; leave --unused out or use "
      "--surface solid");
  const auto unused = place_of(path);
  const auto require_outside = [&](const char* option, const std::string& other) {
    if (other.empty() || other == "-") return;
    require(!is_within(unused, place_of(other)),
            fmt::format("{} {} and --unused {} would lie in one place; give --unused another name",
                        option, other, path));
  };
  require_outside("-o", options.output);
  require_outside("--tetrahedra", options.tetrahedra);
  require_outside("--medial-axis", options.medial_axis);
}

void check_thresholds(const RunOptions& options) {
  require(options.delta_max_degrees > 0 && options.delta_max_degrees <= 180,
          fmt::format("--delta-max {}: give an angle above 0 and up to 180 degrees",
                      options.delta_max_degrees));
  const bool is_radius = options.alpha > 0 && options.alpha <= std::numeric_limits<double>::max();
  require(!options.open_ratio || *options.open_ratio > 0,
          "--open: give a number of spacings above 0, 4 for example");
  if (options.grid_spacing) {
    for (const double spacing : *options.grid_spacing) {
      require(spacing > 0 && spacing <= std::numeric_limits<double>::max(),
              "--spacing: give one length above 0 or three, SX,SY,SZ, in the units of the input");
    }
  }
  require(
      options.pole_tolerance >= 0 && options.pole_tolerance <= std::numeric_limits<double>::max(),
      "--pole-tolerance: give a length of 0 or more in the units of the input");
  require(options.least_ball >= 0 && options.least_ball <= kMostLeastBall,
          "--least-ball: give a number of spacings of the samples from 0 to 100, 1 for example");
  require(options.surface != SurfaceKind::kAlpha || is_radius,
          "--surface alpha needs --alpha R, a radius above 0 in the units of the input");
}

/// Splitting needs a surface that is closed, whose triangles are known to face away from an inside.
void check_manifold(const RunOptions& options) {
  if (!options.manifold) return;
  require(options.surface == SurfaceKind::kSolid || options.surface == SurfaceKind::kCrust,
          fmt::format("--manifold splits surfaces that have an inside, and --surface {} has none; "
                      "leave --manifold out",
                      kind_name(options.surface)));
  require(!options.open_ratio,
          "--manifold splits closed surfaces, and --open leaves facets out; leave one of them out");
}

}  // namespace

void check_options(const RunOptions& options) {
  require(!options.inputs.empty(), "no input: name a file, or - for standard input");
  require(std::count(options.inputs.begin(), options.inputs.end(), "-") <= 1,
          "- is given twice, but standard input can be read once");
  check_output(options);
  check_chunked(options);
  check_unused(options);
  check_thresholds(options);
  check_manifold(options);
  require(options.chunk_points >= 1, "--chunk-points 0: give 1 or more");
}

}  // namespace stream_recon
