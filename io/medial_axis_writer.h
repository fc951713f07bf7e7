// A medial axis on disk, chunk by chunk: balls as points, and triangles and edges between them, in
// a .pvtp index and a folder of .vtp chunks beside it.
//
// Guarantees: as io/chunked_output.h; the bytes written are a function of the chunks alone; without
// a chunk there is one without balls. Memory: a chunk and one block of an array a call of write().
// Thread rule: one thread, but write() is thread-safe. Layout: docs/formats.md.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

#include "io/chunked_output.h"
#include "spatial/point.h"

namespace stream_recon {

/// Arrays of one length, one entry a ball: first those of the chunk, then those of later chunks
/// that its faces touch.
struct MedialAxisChunk {
  std::vector<Point3> centres;
  std::vector<double> radius;
  std::vector<float> angle;             ///< between two of the samples, degrees
  std::vector<std::uint8_t> label;      ///< 0 outside, 1 inside
  std::vector<std::uint64_t> point_id;  ///< input index of a sample that the ball touches

  std::uint64_t own_count = 0;         ///< balls of the chunk
  std::vector<std::uint64_t> pole_id;  ///< the same in all chunks; empty without faces
  /// Positions in this chunk.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::array<std::uint32_t, 2>> edges;
};

class MedialAxisWriter {
 public:
  /// \param path ends in .pvtp \param has_faces PoleId, triangles and edges are written
  /// \throw IoError cannot create; std::invalid_argument the name is nothing but its ending
  MedialAxisWriter(const std::string& path, bool has_faces);

  /// \param number of the chunk among those written, from 0; in any order \throw IoError
  void write(std::uint64_t number, const MedialAxisChunk& chunk);

  /// prepare(), publish(), keep(): as ChunkedOutput. \throw IoError
  void prepare();
  void publish() { output_.publish(); }
  void keep() noexcept { output_.keep(); }

 private:
  ChunkedOutput output_;
  bool has_faces_;
  std::atomic<bool> is_empty_ = true;
};

}  // namespace stream_recon
