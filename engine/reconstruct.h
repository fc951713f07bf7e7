// The door to the whole program: points in, surface and report out.
//
// Guarantees: the bytes of every output depend on the input, the kind of surface with its
// thresholds and chunk_points only, not on memory_bytes or threads. Nothing stands under an
// output's name unless the call returns. Scratch files are gone when it returns; when it throws
// IoError, BudgetError or Interrupted after the points were ordered, they stay, and so they do
// after a kill: a run with the same options and `resume` goes on from the last finished window, to
// the same bytes. Thread rule: one run at a time in a process, since memory is bounded for the
// process as a whole.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "engine/budget.h"
#include "engine/interrupt.h"
#include "engine/progress.h"
#include "engine/report.h"
#include "io/error.h"
#include "io/point_source.h"

namespace stream_recon {

enum class SurfaceKind { kGamma, kAlpha, kSolid, kCrust, kHybrid, kNone };

/// As on the command line.
const char* kind_name(SurfaceKind kind);

/// Which poles are the medial axis: those within the solid, those outside, or all.
enum class PoleSide { kInner, kOuter, kBoth };

/// As on the command line.
inline constexpr std::array<const char*, 3> kPoleSideNames{"inner", "outer", "both"};

struct RunOptions {
  std::vector<std::string> inputs;  ///< files, read one after the other; "-" is standard input
  InputFormat input_format = InputFormat::kAuto;

  /// kCrust, kHybrid and medial_axis_faces add eight far points to the cloud, which the Delaunay
  /// structure and its figures in the report then include (docs/algorithms/crust.md).
  SurfaceKind surface = SurfaceKind::kSolid;
  double delta_max_degrees = 90;  ///< gamma: facets below this angle, (0, 180]
  double alpha = 0;               ///< alpha: radius > 0, units of the input
  /// solid: facets beyond the gamma shape are left out where their circumradius is more than this
  /// many spacings of the samples; > 0. Nothing: the surface is closed.
  std::optional<double> open_ratio;
  /// hybrid: holes of the gamma shape that no patch closes get the triangles of the solid; else
  /// they are left open.
  bool fills_with_solid = false;
  /// solid, crust, hybrid, and with medial_axis: of the grid that the points were sampled on, along
  /// its axes, units of the input; each > 0. Nothing: as the inputs say.
  std::optional<std::array<double, 3>> grid_spacing;

  /// Split the surface where it touches itself, so that it is a manifold. Needs a closed surface:
  /// solid or crust.
  bool manifold = false;

  /// Ends in .pvtp, .ply or .vtk, or is "-" for PLY on standard output; not used for kNone.
  std::string output;
  /// Also writes all finite Delaunay tetrahedra; ends in .pvtu, empty for none. No output lies in
  /// the folder of another's chunks.
  std::string tetrahedra;
  /// Also writes the medial axis, as balls; ends in .pvtp, empty for none. For kSolid, kCrust,
  /// kHybrid and kNone.
  std::string medial_axis;
  PoleSide medial_axis_side = PoleSide::kInner;
  /// The medial axis has the triangles and edges between inner balls as well: the power shape. For
  /// kInner, and kCrust or kNone.
  bool medial_axis_faces = false;
  /// Poles whose centres and radii are equal, rounded to multiples of it, are one; units of the
  /// input, 0: those of the very same ball. For kCrust, kHybrid and medial axes.
  double pole_tolerance = 0;
  /// Poles whose radius is less than so many spacings of their samples are left out; 0: none. For
  /// kCrust, kHybrid and medial axes.
  double least_ball = 0;
  /// Also writes the points that no triangle of the surface has; ends in .ply, empty for none. Not
  /// for kCrust, which has vertices of its own, and kHybrid.
  std::string unused;
  std::uint64_t chunk_points = 100'000;  ///< points of the Hilbert order that share a chunk, >= 1

  /// Bound of the resident set of the whole process, bytes; 0: half of the machine's memory.
  std::uint64_t memory_bytes = 0;
  unsigned threads = 0;  ///< 0: all of the machine
  /// Points that a window owns at most; 0: as many as the memory allows. Changes no output.
  std::uint64_t window_points = 0;
  std::string scratch;  ///< existing folder; empty: beside the output
  std::uint64_t scratch_limit_bytes = std::numeric_limits<std::uint64_t>::max();

  /// Go on from an unfinished run with the same scratch, if there is one.
  bool resume = false;

  ProgressStyle progress = ProgressStyle::kNone;
  /// Told what a person should know and no exit code says, one line at a time; may be empty.
  std::function<void(const std::string&)> on_notice;
  StopRequest* stop = nullptr;  ///< looked at while the run lasts, if given

  /// Whether tetrahedra are labelled inside and outside.
  bool needs_labels() const { return surface == SurfaceKind::kSolid || needs_poles(); }
  /// Whether the poles of the cloud are stored.
  bool needs_poles() const { return needs_power() || !medial_axis.empty(); }
  /// Whether the power diagram of the poles is built, for which far points are added.
  bool needs_power() const {
    return surface == SurfaceKind::kCrust || surface == SurfaceKind::kHybrid || medial_axis_faces;
  }

  /// The folder that the scratch folder is made in.
  std::string scratch_parent() const;
  void say(const std::string& notice) const {
    if (on_notice) on_notice(notice);
  }
};

/// The least memory_bytes that any run accepts.
inline constexpr std::uint64_t kLeastMemory = std::uint64_t{64} << 20;

/// \throw std::invalid_argument the options contradict each other
/// \throw InputError, IoError (io/error.h), BudgetError, Interrupted
Report reconstruct(const RunOptions& options);

}  // namespace stream_recon
