// A piece of the crust as patches see it: sides, what is beyond them, and edges around a vertex.
//
// Guarantees: triangles with a corner twice, out of range or not finite are not there, nor vertices
// without a triangle, so that whatever piece is given is safe to walk on. Of an edge of four
// triangles the pairs that go on flattest are each other's opposite. Thread rule: const after
// construction. Memory: 110 bytes a triangle. Cost: n log n.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/hybrid/crust_piece.h"
#include "engine/hybrid/side_pairs.h"
#include "spatial/neighbors.h"

namespace stream_recon {

class CrustMesh {
 public:
  explicit CrustMesh(const CrustPiece& piece);

  std::span<const Point3> points() const { return points_; }
  std::span<const std::array<std::uint32_t, 3>> triangles() const { return triangles_; }
  std::uint32_t side_count() const { return static_cast<std::uint32_t>(opposite_.size()); }

  std::uint32_t from(std::uint32_t side) const { return triangles_[side / 3][side % 3]; }
  std::uint32_t to(std::uint32_t side) const { return from(next_side(side)); }
  std::uint32_t opposite(std::uint32_t side) const { return opposite_[side]; }
  /// Whether its edge has one triangle at either side.
  bool is_plain(std::uint32_t side) const { return is_plain_[side]; }
  /// Sides that start at the vertex.
  std::span<const std::uint32_t> sides_from(std::uint32_t vertex) const {
    return std::span(sides_).subspan(first_[vertex], first_[vertex + 1] - first_[vertex]);
  }
  /// To ask for vertices near a place.
  const Neighbors& near() const { return *near_; }
  /// Sum of the triangles' normals, twice their area long.
  Point3 normal(std::uint32_t vertex) const;

  /// Four triangles for each, with the middles of edges: finer, and the same surface.
  CrustPiece subdivided() const;

 private:
  void add_triangles(const CrustPiece& piece);
  void pair_up();
  void list_sides();

  std::vector<Point3> points_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::vector<std::uint32_t> opposite_;
  std::vector<bool> is_plain_;
  std::vector<std::uint32_t> first_;  ///< of each vertex, in sides_
  std::vector<std::uint32_t> sides_;
  std::optional<Neighbors> near_;  ///< moves with what points_ holds
};

}  // namespace stream_recon
