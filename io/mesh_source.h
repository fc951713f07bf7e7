// The triangles of a mesh file one after the other, with their corners' numbers and places.
//
// Guarantees: vertices and triangles come in the order of the file; a truncated or malformed file
// throws, it never ends early in silence. Memory: of a .pvtp its largest chunk, of a .vtp all of it
// (memory_bytes() tells before it is read); of a .ply or .vtk cache_bytes, however large it is: its
// points go to scratch and come back through a cache, which is fast where neighbouring triangles
// have neighbouring points, as this program writes them. Thread rule: one reader.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>

#include "io/scratch_directory.h"
#include "spatial/point.h"

namespace stream_recon {

/// Numbers of the three vertices: PoleId or GlobalPointId, or positions in the file where there are
/// none.
using MeshTriangle = std::array<std::uint64_t, 3>;

class MeshVisitor {
 public:
  virtual ~MeshVisitor() = default;
  virtual void vertex(std::uint64_t number, const Point3& point) = 0;
  virtual void triangle(const MeshTriangle& corners, const std::array<Point3, 3>& points) = 0;
};

struct MeshSourceOptions {
  std::string path;  ///< .pvtp, .vtp, .ply or .vtk; "-" is PLY on standard input
  ScratchDirectory* scratch = nullptr;
  std::uint64_t cache_bytes = std::uint64_t{4} << 20;
};

class MeshSource {
 public:
  virtual ~MeshSource() = default;

  /// What read() holds at most, bytes.
  virtual std::uint64_t memory_bytes() const = 0;
  /// Whether a vertex may come several times: at the borders of chunks.
  virtual bool has_copies() const = 0;
  /// Hands everything over, once. \throw InputError, IoError, what the visitor throws
  virtual void read(MeshVisitor& visitor) = 0;
};

/// \throw InputError unknown format, or the head is malformed; IoError
std::unique_ptr<MeshSource> open_mesh_source(const MeshSourceOptions& options);

}  // namespace stream_recon
