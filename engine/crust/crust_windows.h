// The faces of the crust and of the power shape, window by window: all poles inside the body, cut
// into windows by their lowest sample, and what each emits on disk.
//
// Guarantees: every face is in one window's files, whatever the windows; one that
// outgrows its memory is split and built again. Thread rule: one caller; windows side by side.
// Memory: all that the budget has left; a window is given 3200 bytes an owned sample. Cost: about
// 80 us of processor time a sample. Source: docs/algorithms/crust.md, weighted.md
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "engine/crust/crust_sink.h"
#include "engine/power/power_window.h"
#include "engine/shape/shape_faces.h"
#include "engine/stage_context.h"
#include "engine/windows/cloud_index.h"

namespace stream_recon {

/// What one window left; without vertices it has no files.
struct CrustWindow {
  std::uint64_t first_rank = 0;  ///< of its samples
  std::uint32_t vertices = 0;

  std::string vertices_file() const { return "crust_vertices_" + std::to_string(first_rank); }
  std::string triangles_file() const { return "crust_triangles_" + std::to_string(first_rank); }
};

/// What all windows of the power diagram counted.
struct PowerTotals {
  PowerCounts counts;
  std::uint64_t windows = 0;
  std::uint64_t unbounded = 0;  ///< faces left out
};

struct CrustWindows {
  std::vector<CrustWindow> windows;  ///< as CrustVertex::window numbers them
  PowerTotals power;
  std::uint64_t faces = 0;
  std::uint64_t splits = 0;
  std::vector<std::uint64_t> shape_windows;  ///< first ranks of those that left faces of the shape
  ShapeCounts shape;
};

struct CrustWindowOptions {
  unsigned threads = 1;
  /// Samples of a window at most; 0: as many as the memory allows.
  std::uint64_t window_points = 0;
  /// Ranks of the points that are no samples (order/far_points.h), ascending.
  std::vector<std::uint32_t> far_ranks;
  bool has_crust = true;  ///< its faces are written
  /// Only the poles that touch one of these have their faces made; null: all.
  const SampleChoice* choice = nullptr;
  /// Makes what takes the faces of a window, by its first rank, instead of the files of
  /// CrustWindow; called, and used, by several threads at once. It holds as many bytes a vertex as
  /// said below.
  std::function<std::unique_ptr<CrustSink>(std::uint64_t)> make_sink = {};
  std::uint64_t sink_bytes_a_vertex = 0;
  bool has_shape = false;  ///< those of the power shape are (shape/shape_store.h)
};

/// \pre The pole store and the index are in the scratch directory.
/// \throw BudgetError, IoError, InputError, Interrupted
CrustWindows build_crust_windows(const CloudIndex& index, const CrustWindowOptions& options,
                                 const StageContext& context);

}  // namespace stream_recon
