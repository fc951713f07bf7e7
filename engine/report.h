// What a run did, in numbers; the keys of its JSON are a contract with other programs
// (docs/formats.md).
//
// Thread rule: a value.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/power/power_seconds.h"

namespace stream_recon {

struct StageReport {
  std::string name;
  double start_seconds = 0;  ///< since the run's start
  double seconds = 0;
  std::uint64_t bytes_read = 0;
  std::uint64_t bytes_written = 0;
};

struct MemorySample {
  double seconds = 0;  ///< since the run's start
  std::uint64_t resident_bytes = 0;
};

/// How many triangles have an angle Delta in each degree: [0, 1), [1, 2), ... [179, 180].
using DeltaHistogram = std::array<std::uint64_t, 180>;

/// The poles of the cloud (engine/poles/pole_stage.h).
struct PoleReport {
  std::uint64_t count = 0;       ///< distinct balls
  std::uint64_t coincident = 0;  ///< tetrahedra whose ball is another's, merged with it
  std::uint64_t unbounded = 0;   ///< samples with a pole without a ball: at infinity, mostly
  std::uint64_t small = 0;       ///< samples with a pole that is left out, once a pole
  std::uint64_t inner = 0;
  std::uint64_t outer = 0;
  std::uint64_t conflicts = 0;  ///< balls whose tetrahedra do not all lie on one side
};

/// The windows of the power diagram (engine/power/power_window.h).
struct PowerReport {
  std::uint64_t windows = 0;
  std::uint64_t poles = 0;            ///< inner ones, whose stars were proved
  std::uint64_t guests = 0;           ///< poles beside them, of all windows
  std::uint64_t rounds = 0;           ///< of all windows
  std::uint64_t walks = 0;            ///< one for each cell asked about, and for each sample closed
  std::uint64_t tests = 0;            ///< of a tetrahedron against the sphere of a cell
  std::uint64_t unbounded_faces = 0;  ///< left out: they reach infinity
  PowerSeconds seconds;
};

/// The power shape: simplices of the power diagram's dual whose poles are all inside.
struct ShapeReport {
  std::uint64_t vertices = 0;
  std::uint64_t edges = 0;
  std::uint64_t bare_edges = 0;  ///< of these: without a triangle
  std::uint64_t triangles = 0;
  std::uint64_t tetrahedra = 0;

  /// That of the body.
  std::int64_t euler() const {
    return static_cast<std::int64_t>(vertices + triangles) -
           static_cast<std::int64_t>(edges + tetrahedra);
  }
};

/// How the holes of the gamma shape were closed (engine/hybrid/hybrid_stage.h).
struct HybridReport {
  std::uint64_t holes = 0;
  std::uint64_t by_triangles = 0;  ///< closed by triangles over their rings
  std::uint64_t by_crust = 0;      ///< closed by patches of the crust
  std::uint64_t by_solid = 0;      ///< no patch: filled by the solid's triangles
  std::uint64_t left_out = 0;      ///< no patch: left open
  std::uint64_t patch_triangles = 0;
  std::uint64_t kept_fills = 0;  ///< of these: the solid's, where the crust was of no use
  std::uint64_t added_vertices = 0;
  std::uint64_t unused_samples = 0;  ///< samples within patches, without a triangle of them
};

struct Report {
  struct {
    std::uint64_t points = 0;      ///< as delivered, duplicates and rejected ones included
    std::uint64_t duplicates = 0;  ///< merged into a point of lower index
    std::uint64_t rejected = 0;    ///< not finite
    /// Of the grid the points were sampled on, where an input says it.
    std::optional<std::array<double, 3>> spacing;
  } input;
  struct {
    std::uint64_t tetrahedra = 0;  ///< finite ones; of a crust with its far points
    std::string digest;            ///< spatial/simplex_digest.h, 16 hex digits
  } delaunay;
  struct {
    std::string kind;
    std::uint64_t vertices = 0;
    std::uint64_t triangles = 0;
    std::string digest;
    std::uint64_t boundary_edges = 0;     ///< edges of one triangle
    std::uint64_t nonmanifold_edges = 0;  ///< edges of three and more
    std::int64_t euler = 0;               ///< vertices - edges + triangles
    /// Pieces of triangles that hang together at edges, but for cavities. Of solids two triangles
    /// hang together where they bound the same part of the inside, so that bodies that touch along
    /// an edge or at a vertex count as two.
    std::uint64_t components = 0;
    std::uint64_t cavities = 0;  ///< of solids: closed pieces around a hollow
    /// Handles of all components and cavities; only where every piece of a solid is closed.
    std::optional<std::int64_t> genus;
    std::optional<double> volume;          ///< likewise; cubes of the unit of the input
    double area = 0;                       ///< squares of the unit of the input
    std::uint64_t samples_on_surface = 0;  ///< distinct points that are vertices
    std::uint64_t unused_samples = 0;      ///< distinct points without
    std::uint64_t doubtful_fills = 0;      ///< fills of a closure above 4 (docs/formats.md)
    std::uint64_t forest_conflicts = 0;    ///< of solids: evidence that the labels contradict
    DeltaHistogram delta_histogram{};
  } surface;
  std::optional<PoleReport> poles;  ///< where the run needed them
  std::optional<PowerReport> power;
  std::optional<ShapeReport> shape;
  std::optional<HybridReport> hybrid;
  struct {
    std::uint64_t count = 0;
    std::uint64_t splits = 0;       ///< windows that were begun too large
    std::uint64_t guests = 0;       ///< points in windows that do not own them, all windows
    std::uint64_t rounds = 0;       ///< of all windows
    std::uint64_t queries = 0;      ///< cells asked about
    std::uint64_t node_visits = 0;  ///< cells tested against nodes of the index
    std::uint64_t exact_tests = 0;  ///< points that doubles could not tell from in conflict
    double insert_seconds = 0;      ///< inside windows, sum over threads
    double search_seconds = 0;
  } windows;
  std::uint64_t peak_rss_bytes = 0;
  std::uint64_t scratch_peak_bytes = 0;
  double seconds = 0;
  std::vector<StageReport> stages;
  std::vector<MemorySample> memory_over_time;  ///< at most 512, while the stages ran
  unsigned threads = 0;
  std::uint64_t memory_budget_bytes = 0;
  std::string version;
};

/// Indented JSON with a final newline; lists of numbers take a line each.
std::string to_json(const Report& report);

/// Puts the JSON under `path`, complete or not at all; "-" is standard output. \throw IoError
void write_report(const Report& report, const std::string& path);

}  // namespace stream_recon
