// The facts of a small mesh found in core with plain maps: what mesh-check must agree with.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "spatial/point.h"
#include "tools/check/mesh_facts.h"

namespace stream_recon {

struct TestMesh {
  std::vector<Point3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Groups what is joined, in a plain map.
template <class Key>
class Groups {
 public:
  void add(const Key& key) { parents_.try_emplace(key, key); }
  void join(const Key& a, const Key& b) {
    add(a);
    add(b);
    parents_[root(a)] = root(b);
  }
  Key root(Key key) {
    while (parents_.at(key) != key) key = parents_.at(key) = parents_.at(parents_.at(key));
    return key;
  }
  std::size_t count() const {
    return static_cast<std::size_t>(
        std::count_if(parents_.begin(), parents_.end(),
                      [](const auto& pair) { return pair.first == pair.second; }));
  }
  const std::map<Key, Key>& all() const { return parents_; }

 private:
  std::map<Key, Key> parents_;
};

/// All but area, volume, box and contradictory ids. Coordinates are small integers, for which
/// doubles are exact.
class MeshOracle {
 public:
  explicit MeshOracle(const TestMesh& mesh) : mesh_(mesh) {
    for (const auto& triangle : mesh.triangles) take(triangle);
    count_vertices();
    count_edges();
    count_rings();
    count_components();
  }

  const MeshFacts& facts() const { return facts_; }

 private:
  using Id = std::uint32_t;
  using Edge = std::pair<Id, Id>;
  struct Uses {
    int up = 0, down = 0;
    int all() const { return up + down; }
  };

  void take(const std::array<Id, 3>& t) {
    ++facts_.triangles;
    const Point3 &a = mesh_.points[t[0]], &b = mesh_.points[t[1]], &c = mesh_.points[t[2]];
    const Point3 u{b.x - a.x, b.y - a.y, b.z - a.z}, v{c.x - a.x, c.y - a.y, c.z - a.z};
    if (u.y * v.z == u.z * v.y && u.z * v.x == u.x * v.z && u.x * v.y == u.y * v.x) {
      ++facts_.zero_area_triangles;
    }
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) {
      ++facts_.repeated_corner_triangles;
      return;
    }
    std::array<Id, 3> sorted = t;
    std::sort(sorted.begin(), sorted.end());
    if (!seen_.insert(sorted).second) ++facts_.duplicate_triangles;
    for (int i = 0; i < 3; ++i) {
      const Id from = t[i], to = t[(i + 1) % 3], opposite = t[(i + 2) % 3];
      Uses& uses = edges_[std::minmax(from, to)];
      ++(from < to ? uses.up : uses.down);
      components_.join(from, to);
      links_[opposite].emplace_back(from, to);
    }
    triangles_of_.emplace_back(t[0]);
  }

  void count_vertices() {
    facts_.vertices = links_.size();
    facts_.unused_vertices = mesh_.points.size() - links_.size();
    for (const auto& [vertex, link] : links_) {
      Groups<Id> parts;
      std::map<Id, int> degrees;
      for (const auto& [from, to] : link) {
        parts.join(from, to);
        ++degrees[from];
        ++degrees[to];
      }
      const bool branches = std::any_of(degrees.begin(), degrees.end(),
                                        [](const auto& pair) { return pair.second > 2; });
      if (branches || parts.count() != 1) {
        ++facts_.nonmanifold_vertices;
        nonmanifold_.insert(components_.root(vertex));
      }
    }
  }

  void count_edges() {
    facts_.edges = edges_.size();
    for (const auto& [edge, uses] : edges_) {
      const Id component = components_.root(edge.first);
      --euler_[component];
      if (uses.all() == 1) {
        ++facts_.boundary_edges;
        open_.insert(component);
      }
      if (uses.all() > 2) {
        ++facts_.nonmanifold_edges;
        nonmanifold_.insert(component);
      }
      if (uses.all() == 2 && uses.up != 1) {
        ++facts_.wrongly_oriented_edges;
        twisted_.insert(component);
      }
    }
  }

  void count_rings() {
    Groups<Id> rings;
    std::map<Id, int> degrees;
    for (const auto& [edge, uses] : edges_) {
      if (uses.all() != 1) continue;
      rings.join(edge.first, edge.second);
      ++degrees[edge.first];
      ++degrees[edge.second];
    }
    std::set<Id> branching;
    for (const auto& [vertex, degree] : degrees) {
      if (degree != 2) branching.insert(rings.root(vertex));
    }
    facts_.boundary_rings = rings.count();
    facts_.simple_boundary_rings = rings.count() - branching.size();
  }

  void count_components() {
    std::map<Id, std::uint64_t> sizes;
    for (const Id corner : triangles_of_) {
      ++sizes[components_.root(corner)];
      ++euler_[components_.root(corner)];
    }
    for (const auto& [vertex, parent] : components_.all()) ++euler_[components_.root(vertex)];
    facts_.components = components_.count();
    for (const auto& [component, size] : sizes) {
      facts_.largest_component_triangles = std::max(facts_.largest_component_triangles, size);
      const bool closed = open_.count(component) == 0;
      const bool manifold = nonmanifold_.count(component) == 0;
      const bool oriented = twisted_.count(component) == 0;
      facts_.closed_components += closed ? 1 : 0;
      facts_.manifold_components += manifold ? 1 : 0;
      facts_.oriented_components += oriented ? 1 : 0;
      if (closed && manifold && oriented) {
        ++facts_.components_by_genus[(2 - euler_[component]) / 2];
      }
    }
  }

  const TestMesh& mesh_;
  MeshFacts facts_;
  std::set<std::array<Id, 3>> seen_;
  std::map<Edge, Uses> edges_;
  std::map<Id, std::vector<Edge>> links_;
  Groups<Id> components_;
  std::vector<Id> triangles_of_;  ///< a corner of each
  std::set<Id> open_, nonmanifold_, twisted_;
  std::map<Id, std::int64_t> euler_;
};

}  // namespace stream_recon
