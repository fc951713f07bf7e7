// Writes test meshes in the formats that mesh-check reads.
#pragma once

#include <algorithm>
#include <map>
#include <sstream>
#include <string>

#include "io/scratch_directory.h"
#include "io/surface_writer.h"
#include "tests/io_test_folder.h"
#include "tests/mesh_oracle.h"

namespace stream_recon {

/// Cuts a mesh into chunks of so many triangles; vertices of several chunks are repeated.
inline std::vector<SurfaceChunk> chunks_of(const TestMesh& mesh, std::size_t triangles) {
  std::vector<SurfaceChunk> chunks;
  for (std::size_t begin = 0; begin < mesh.triangles.size(); begin += triangles) {
    SurfaceChunk& chunk = chunks.emplace_back();
    std::map<std::uint32_t, std::uint32_t> positions;
    const std::size_t end = std::min(begin + triangles, mesh.triangles.size());
    for (std::size_t i = begin; i < end; ++i) {
      std::array<std::uint32_t, 3> local{};
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const std::uint32_t id = mesh.triangles[i][corner];
        const auto [found, is_new] =
            positions.try_emplace(id, static_cast<std::uint32_t>(positions.size()));
        if (is_new) {
          chunk.points.push_back(mesh.points[id]);
          chunk.global_ids.push_back(id);
        }
        local[corner] = found->second;
      }
      chunk.triangles.push_back(local);
      chunk.delta.push_back(0);
      chunk.source.push_back(TriangleSource::kGamma);
    }
  }
  return chunks;
}

inline void write_chunked(const TestMesh& mesh, const std::string& path, std::size_t triangles) {
  const auto writer = make_surface_writer({.path = path});
  std::uint64_t number = 0;
  for (const SurfaceChunk& chunk : chunks_of(mesh, triangles)) writer->write(number++, chunk);
  writer->finish();
}

/// As one .ply or .vtk of this program's own writers: without the points that are not used.
inline void write_single(const TestMesh& mesh, const TestFolder& folder, const std::string& path) {
  ScratchDirectory scratch({.parent = folder.path()});
  const auto writer = make_surface_writer({.path = path, .scratch = &scratch});
  for (SurfaceChunk& chunk : chunks_of(mesh, mesh.triangles.size())) {
    for (std::size_t i = 0; i < chunk.points.size(); ++i) chunk.vertex_numbers.push_back(i);
    writer->write(0, chunk);
  }
  writer->finish();
}

/// As a PLY in text, with all points and a property that nobody asked for.
inline std::string ascii_ply(const TestMesh& mesh) {
  std::ostringstream out;
  out.precision(17);
  out << "ply\nformat ascii 1.0\nelement vertex " << mesh.points.size()
      << "\nproperty double x\nproperty uchar red\nproperty double y\nproperty double z\n"
      << "element face " << mesh.triangles.size()
      << "\nproperty list uchar int vertex_indices\nproperty float quality\nend_header\n";
  for (const Point3& p : mesh.points) out << p.x << " 255 " << p.y << ' ' << p.z << '\n';
  for (const auto& t : mesh.triangles)
    out << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << " 0.5\n";
  return out.str();
}

}  // namespace stream_recon
