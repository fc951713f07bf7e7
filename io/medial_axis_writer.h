// A medial axis on disk, chunk by chunk: balls as points, in a .pvtp index and a folder of .vtp
// chunks beside it.
//
// Guarantees: as io/chunked_output.h; the bytes written are a function of the chunks alone; without
// a chunk there is one without balls. Memory: a chunk and one block of an array a call of write().
// Thread rule: one thread, but write() is thread-safe. Layout: docs/formats.md.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

#include "io/chunked_output.h"
#include "spatial/point.h"

namespace stream_recon {

/// Arrays of one length.
struct MedialAxisChunk {
  std::vector<Point3> centres;
  std::vector<double> radius;
  std::vector<float> angle;             ///< between two of the samples, degrees
  std::vector<std::uint8_t> label;      ///< 0 outside, 1 inside
  std::vector<std::uint64_t> point_id;  ///< input index of a sample that the ball touches
};

class MedialAxisWriter {
 public:
  /// \param path ends in .pvtp
  /// \throw IoError cannot create; std::invalid_argument the name is nothing but its ending
  explicit MedialAxisWriter(const std::string& path);

  /// \param number of the chunk among those written, from 0; in any order \throw IoError
  void write(std::uint64_t number, const MedialAxisChunk& chunk);

  /// prepare(), publish(), keep(): as ChunkedOutput. \throw IoError
  void prepare();
  void publish() { output_.publish(); }
  void keep() noexcept { output_.keep(); }

 private:
  ChunkedOutput output_;
  std::atomic<bool> is_empty_ = true;
};

}  // namespace stream_recon
