// Tetrahedra on disk, chunk by chunk: a .pvtu index and a folder of .vtu chunks beside it.
//
// Guarantees: as io/chunked_output.h; the bytes written are a function of the chunks alone. Arrays
// are appended raw and compressed; layout: docs/formats.md.
// Memory: a chunk and one block of an array a call of write(). Thread rule: one thread, but write()
// is thread-safe.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "io/chunked_output.h"
#include "io/coordinates.h"
#include "spatial/point.h"

namespace stream_recon {

/// A part of the tetrahedralization; every point is a corner of one of its tetrahedra.
struct TetrahedraChunk {
  std::vector<Point3> points;             ///< bit-equal to the input
  std::vector<std::uint64_t> global_ids;  ///< input index of each point
  /// Positions in `points`; the first three are counterclockwise seen from the fourth.
  std::vector<std::array<std::uint32_t, 4>> tetrahedra;
};

struct TetrahedraWriterOptions {
  std::string path;  ///< ends in .pvtu
  /// kFloat32 only where every input coordinate is a float32: output stays bit-equal.
  Scalar coordinates = Scalar::kFloat64;
};

class TetrahedraWriter {
 public:
  /// \throw IoError cannot create; std::invalid_argument the name is nothing but its ending
  explicit TetrahedraWriter(const TetrahedraWriterOptions& options);

  /// \param number of the chunk among those written, from 0; in any order \throw IoError
  void write(std::uint64_t number, const TetrahedraChunk& chunk);

  /// prepare(), publish(), keep(): as ChunkedOutput, so that a result of several files can appear
  /// whole or not at all. \throw IoError
  void prepare();
  void publish() { output_.publish(); }
  void keep() noexcept { output_.keep(); }

 private:
  Scalar scalar_;
  ChunkedOutput output_;
};

}  // namespace stream_recon
