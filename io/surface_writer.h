// Surfaces on disk, chunk by chunk.
//
// Guarantees: nothing stands under the final name until finish(); a writer destroyed before that
// removes what it wrote. The bytes written are a function of the chunks alone.
// Memory: one encoded chunk a call of write(). Thread rule: one thread, but write() as said there.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "io/coordinates.h"
#include "spatial/point.h"

namespace stream_recon {

class ScratchDirectory;

/// Why a triangle is there: the values of cell data `Source`.
enum class TriangleSource : std::uint8_t {
  kGamma = 0,
  kAlpha = 1,
  kFill = 2,   ///< of the solid, beyond the gamma shape
  kCrust = 3,  ///< between a ball inside and one outside
  kPatch = 4,  ///< of the hybrid: closes a hole of the gamma shape
};

/// A part of the surface. Arrays of points have one length, arrays of triangles another; every
/// point is a corner of a triangle of the chunk.
struct SurfaceChunk {
  std::vector<Point3> points;  ///< bit-equal to the input where they are samples
  /// Input index of each point; of a crust's vertices that are no samples numbers above all those.
  std::vector<std::uint64_t> global_ids;
  /// Of a surface that is split into sheets: which sheet at that point; then points of one id stand
  /// one after the other. Else empty.
  std::vector<std::uint32_t> sheets;
  /// For writers that take chunks in order: position of each point in the vertex list of the whole
  /// surface, counted in the order of first appearance (chunk by chunk, then by position in the
  /// chunk): a point is new in this chunk iff its number is not below the count of vertices of all
  /// chunks before.
  std::vector<std::uint64_t> vertex_numbers;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< positions in `points`
  std::vector<float> delta;                             ///< angle of the facet's balls, degrees
  std::vector<TriangleSource> source;
  /// Circumradius of each triangle over the local spacing; empty where it is not known.
  std::vector<float> closure;
};

struct SurfaceWriterOptions {
  /// Ends in .pvtp, .ply or .vtk, or is "-" (binary PLY on standard output).
  std::string path;
  /// kFloat32 only where every input coordinate is a float32: output stays bit-equal.
  Scalar coordinates = Scalar::kFloat64;
  /// Where single-file formats keep their parts until the counts are known; must outlive the
  /// writer. Not needed for .pvtp.
  ScratchDirectory* scratch = nullptr;
  /// Whether the chunks know their closure: it is written where cells have data.
  bool has_closure = false;
  bool has_sheets = false;  ///< chunks have them: .pvtp tells of them
};

class SurfaceWriter {
 public:
  virtual ~SurfaceWriter() = default;
  /// Whether chunks must come one after the other, by ascending number, with vertex numbers. Else
  /// they may come side by side from several threads, in any order.
  virtual bool takes_chunks_in_order() const = 0;
  /// \param number of the chunk among those written, from 0 \throw IoError
  virtual void write(std::uint64_t number, const SurfaceChunk& chunk) = 0;
  /// No more chunks: completes the output, under another name still, so that finish() has nothing
  /// but renames to do. What goes to standard output is there after it. \throw IoError
  void prepare() {
    if (!is_prepared_) complete();
    is_prepared_ = true;
  }
  /// Prepares, and puts the output under its final name, the index last. \throw IoError
  void finish() {
    prepare();
    publish();
  }
  virtual std::uint64_t bytes_written() const = 0;

 private:
  virtual void complete() = 0;
  virtual void publish() = 0;

  bool is_prepared_ = false;
};

/// \throw IoError cannot create; std::invalid_argument unknown ending, no scratch
std::unique_ptr<SurfaceWriter> make_surface_writer(const SurfaceWriterOptions& options);

}  // namespace stream_recon
