// A batch of triangles, with what hangs together in it.
//
// Guarantees: pieces are numbered in the order of their first triangles. Thread rule: one thread.
// Memory: memory_bytes(). Cost: about 50 ns a triangle.
#pragma once

#include <cstdint>
#include <vector>

#include "io/mesh_source.h"

namespace stream_recon {

class TriangleBatch {
 public:
  struct Entry {
    MeshTriangle corners;     ///< three different ones
    double volume = 0;        ///< with the origin of the mesh
    std::uint32_t piece = 0;  ///< set by number_pieces()
  };

  TriangleBatch();

  bool is_full() const { return entries_.size() == kTriangles; }
  /// \pre not full
  void add(const MeshTriangle& corners, double volume);
  /// Says of each triangle which piece it is of; the number of pieces.
  std::uint32_t number_pieces();
  const std::vector<Entry>& entries() const { return entries_; }
  void clear();

  static constexpr std::uint64_t memory_bytes() {
    return kTriangles * (sizeof(Entry) + 3 * (sizeof(std::uint64_t) + 2 * sizeof(std::uint32_t))) +
           kSlots * sizeof(std::uint32_t);
  }

 private:
  static constexpr std::size_t kTriangles = std::size_t{1} << 15;
  static constexpr std::size_t kSlots = std::size_t{1} << 18;  ///< for up to 3 * 2^15 vertices

  std::uint32_t position_of(std::uint64_t vertex);
  std::uint32_t root_of(std::uint32_t position);

  std::vector<Entry> entries_;
  std::vector<std::uint32_t> slots_;     ///< of the hash table: position + 1, 0 if free
  std::vector<std::uint64_t> vertices_;  ///< by position
  std::vector<std::uint32_t> parents_;   ///< of the positions
};

}  // namespace stream_recon
