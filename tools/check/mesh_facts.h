// What mesh-check finds out about a mesh. Each number is defined in docs/mesh-check.md.
//
// Thread rule: a value.
#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include "spatial/box.h"

namespace stream_recon {

struct MeshFacts {
  std::uint64_t triangles = 0;
  std::uint64_t repeated_corner_triangles = 0;  ///< left out of all topology
  std::uint64_t zero_area_triangles = 0;        ///< corners exactly collinear, the above included
  std::uint64_t duplicate_triangles = 0;        ///< beyond the first of the same three corners

  std::uint64_t vertices = 0;         ///< of triangles
  std::uint64_t unused_vertices = 0;  ///< of no triangle
  std::uint64_t nonmanifold_vertices = 0;
  std::uint64_t contradictory_ids = 0;  ///< ids whose copies differ in their coordinates

  std::uint64_t edges = 0;
  std::uint64_t boundary_edges = 0;
  std::uint64_t nonmanifold_edges = 0;
  std::uint64_t wrongly_oriented_edges = 0;
  std::uint64_t boundary_rings = 0;
  std::uint64_t simple_boundary_rings = 0;

  std::uint64_t components = 0;
  std::uint64_t closed_components = 0;    ///< without boundary edges
  std::uint64_t manifold_components = 0;  ///< without non-manifold edges and vertices
  std::uint64_t oriented_components = 0;  ///< without wrongly oriented edges
  std::uint64_t largest_component_triangles = 0;
  /// Of the components that are closed, manifold and oriented: genus, and how many have it.
  std::map<std::int64_t, std::uint64_t> components_by_genus;

  Box3 box;         ///< of the corners of all triangles
  double area = 0;  ///< in squared units of the coordinates
  /// Of the components all of whose edges are run as often one way as the other; none without any.
  std::optional<double> volume;

  std::int64_t euler() const {
    return static_cast<std::int64_t>(vertices + triangles - repeated_corner_triangles) -
           static_cast<std::int64_t>(edges);
  }
  /// Of all components in components_by_genus; nothing if there is none.
  std::optional<std::int64_t> genus() const {
    if (components_by_genus.empty()) return std::nullopt;
    std::int64_t sum = 0;
    for (const auto& [genus, count] : components_by_genus) {
      sum += genus * static_cast<std::int64_t>(count);
    }
    return sum;
  }
  bool is_closed() const { return boundary_edges == 0; }
  bool is_manifold() const { return nonmanifold_edges == 0 && nonmanifold_vertices == 0; }
  bool is_oriented() const { return wrongly_oriented_edges == 0; }
};

}  // namespace stream_recon
