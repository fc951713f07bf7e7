#include "engine/restart/run_identity.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <filesystem>
#include <vector>

#include "engine/version.h"
#include "io/checksum.h"

namespace stream_recon {
namespace {

constexpr std::array kOutputs{"output", "--tetrahedra", "--unused", "--medial-axis"};

constexpr std::uint64_t kSample = std::uint64_t{64} << 10;

std::string absolute_path(const std::string& path) {
  if (path.empty() || path == "-") return path;
  std::error_code error;
  const auto absolute = std::filesystem::weakly_canonical(path, error);
  return error ? path : absolute.string();
}

/// Of the beginning, the middle and the end.
std::uint64_t sample_checksum(const std::string& path, std::uint64_t size) {
  const File file = File::open(path);
  std::vector<std::byte> sample(std::min(kSample, size));
  std::uint64_t sum = 0;
  for (const std::uint64_t at : {std::uint64_t{0}, size / 2, size - sample.size()}) {
    file.read_at(std::min(at, size - sample.size()), sample);
    sum = checksum64(sample, sum);
  }
  return sum;
}

std::string describe_input(const std::string& path) {
  if (path == "-") return path;
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) throw_system_error("open", path, errno);
  if (!S_ISREG(status.st_mode)) return absolute_path(path);
  const auto size = static_cast<std::uint64_t>(status.st_size);
  return fmt::format("{}, {} bytes, changed at {}.{:09}, checksum {:016x}", absolute_path(path),
                     size, status.st_mtim.tv_sec, status.st_mtim.tv_nsec,
                     sample_checksum(path, size));
}

std::string value_of(const RunIdentity& identity, const char* key) {
  const auto at = identity.find(key);
  return at == identity.end() ? "" : at->second;
}

}  // namespace

RunIdentity identity_of(const RunOptions& options) {
  RunIdentity identity{
      {"version", version()},
      {"output", options.surface == SurfaceKind::kNone ? "" : absolute_path(options.output)},
      {"--tetrahedra", absolute_path(options.tetrahedra)},
      {"--unused", absolute_path(options.unused)},
      {"--medial-axis", absolute_path(options.medial_axis)},
      {"--surface", kind_name(options.surface)},
      {"--chunk-points", fmt::format("{}", options.chunk_points)},
      {"--input-format", kInputFormatNames.at(static_cast<std::size_t>(options.input_format))}};
  if (options.surface == SurfaceKind::kGamma) {
    identity["--delta-max"] = fmt::format("{}", options.delta_max_degrees);
  }
  if (options.surface == SurfaceKind::kAlpha) {
    identity["--alpha"] = fmt::format("{}", options.alpha);
  }
  if (options.surface == SurfaceKind::kSolid && options.open_ratio) {
    identity["--open"] = fmt::format("{}", *options.open_ratio);
  }
  if (options.surface == SurfaceKind::kHybrid) {
    identity["--fill"] = options.fills_with_solid ? "solid" : "none";
  }
  if (options.needs_labels() && options.grid_spacing) {
    identity["--spacing"] = fmt::format("{}", fmt::join(*options.grid_spacing, ","));
  }
  if (options.needs_poles()) {
    identity["--pole-tolerance"] = fmt::format("{}", options.pole_tolerance);
    identity["--least-ball"] = fmt::format("{}", options.least_ball);
  }
  if (!options.medial_axis.empty()) {
    identity["--medial-axis-side"] =
        kPoleSideNames.at(static_cast<std::size_t>(options.medial_axis_side));
  }
  if (options.medial_axis_faces) identity["--medial-axis-faces"] = "given";
  if (options.manifold) identity["--manifold"] = "given";
  for (std::size_t i = 0; i < options.inputs.size(); ++i) {
    identity[fmt::format("input {}", i + 1)] = describe_input(options.inputs[i]);
  }
  return identity;
}

bool writes_files(const RunIdentity& identity) {
  return std::any_of(kOutputs.begin(), kOutputs.end(), [&](const char* key) {
    const std::string output = value_of(identity, key);
    return !output.empty() && output != "-";
  });
}

bool have_same_outputs(const RunIdentity& a, const RunIdentity& b) {
  for (const char* key : kOutputs) {
    if (value_of(a, key) != value_of(b, key)) return false;
  }
  return writes_files(a) || value_of(a, "input 1") == value_of(b, "input 1");
}

std::optional<std::string> difference(const RunIdentity& before, const RunIdentity& now) {
  const auto describe = [](const RunIdentity& identity, const std::string& key) {
    const auto at = identity.find(key);
    return at == identity.end() ? std::string("nothing") : at->second;
  };
  for (const RunIdentity* side : {&before, &now}) {
    for (const auto& entry : *side) {
      const std::string& key = entry.first;
      const std::string then = describe(before, key);
      const std::string here = describe(now, key);
      if (then != here) return fmt::format("{}: {} then, {} now", key, then, here);
    }
  }
  return std::nullopt;
}

}  // namespace stream_recon
