// Points alone as one binary PLY, chunk by chunk.
//
// Guarantees: points are bit-equal and stand in the order of the chunks, whatever order those come
// in. prepare(), publish(), keep(): as ChunkedOutput, so that a result of several files can appear
// whole or not at all; an object that goes before keep() takes its result away and puts an older
// one back. Memory: 16 bytes a chunk, and an encoded chunk a call of write(). Thread rule: one
// thread, but write() is thread-safe. Cost: every byte is written twice and read once, since the
// header has the count. Layout: docs/formats.md.
#pragma once

#include <cstdint>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/coordinates.h"
#include "io/file.h"
#include "io/rename_sequence.h"
#include "io/scratch_directory.h"
#include "io/temporary_path.h"
#include "spatial/point.h"

namespace stream_recon {

struct PointsWriterOptions {
  std::string path;  ///< ends in .ply
  /// kFloat32 only where every input coordinate is a float32: output stays bit-equal.
  Scalar coordinates = Scalar::kFloat64;
  ScratchDirectory* scratch = nullptr;  ///< keeps the points until all are known; outlives this
};

class PointsWriter {
 public:
  /// \throw IoError cannot create
  explicit PointsWriter(PointsWriterOptions options);
  ~PointsWriter();
  PointsWriter(const PointsWriter&) = delete;
  PointsWriter& operator=(const PointsWriter&) = delete;

  /// \param chunk any number, each at most once \throw IoError
  void write(std::uint64_t chunk, std::span<const Point3> points);

  /// No more points: completes the file, under another name. \throw IoError
  void prepare();
  /// \pre prepare() \throw IoError
  void publish();
  /// The result stays, an older one is removed. \pre publish()
  void keep() noexcept;

 private:
  /// Where the points of a chunk lie among those written.
  struct Part {
    std::uint64_t chunk = 0;
    std::uint64_t offset = 0;
    std::uint64_t count = 0;
  };

  std::string header() const;
  void move_parts_to(File& target);

  PointsWriterOptions options_;
  std::string old_;
  File file_;
  // The renames are undone before the staged file is removed: members go in reverse order.
  TemporaryPath staged_;
  RenameSequence renames_;
  std::mutex mutex_;
  File spool_;
  std::vector<Part> parts_;
};

}  // namespace stream_recon
