#include "tools/check/facts_text.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace stream_recon {
namespace {

using Json = nlohmann::ordered_json;

Json point_json(const Point3& p) {
  return {p.x, p.y, p.z};
}

/// A value that may be missing.
template <class T>
Json optional_json(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json genus_json(const MeshFacts& facts) {
  Json counts = Json::object();
  for (const auto& [genus, count] : facts.components_by_genus)
    counts[std::to_string(genus)] = count;
  return counts;
}

std::string genus_text(const MeshFacts& facts) {
  std::string text;
  constexpr std::size_t kMost = 4;
  std::size_t shown = 0;
  for (const auto& [genus, count] : facts.components_by_genus) {
    if (shown == kMost) return text + ", ...";
    text += fmt::format("{}{} of genus {}", shown++ == 0 ? "" : ", ", count, genus);
  }
  return text;
}

const char* yes_no(bool holds) {
  return holds ? "yes" : "no";
}

}  // namespace

std::string facts_json(const MeshFacts& facts) {
  const bool has_box = !facts.box.empty();
  const Json json{
      {"triangles", facts.triangles},
      {"degenerate_triangles", facts.zero_area_triangles},
      {"repeated_corner_triangles", facts.repeated_corner_triangles},
      {"duplicate_triangles", facts.duplicate_triangles},
      {"vertices", facts.vertices},
      {"unused_vertices", facts.unused_vertices},
      {"nonmanifold_vertices", facts.nonmanifold_vertices},
      {"contradictory_ids", facts.contradictory_ids},
      {"edges", facts.edges},
      {"boundary_edges", facts.boundary_edges},
      {"nonmanifold_edges", facts.nonmanifold_edges},
      {"wrongly_oriented_edges", facts.wrongly_oriented_edges},
      {"boundary_rings", facts.boundary_rings},
      {"simple_boundary_rings", facts.simple_boundary_rings},
      {"closed", facts.is_closed()},
      {"manifold", facts.is_manifold()},
      {"oriented", facts.is_oriented()},
      {"components", facts.components},
      {"closed_components", facts.closed_components},
      {"manifold_components", facts.manifold_components},
      {"oriented_components", facts.oriented_components},
      {"largest_component_triangles", facts.largest_component_triangles},
      {"euler", facts.euler()},
      {"genus", optional_json(facts.genus())},
      {"components_by_genus", genus_json(facts)},
      {"area", facts.area},
      {"volume", optional_json(facts.volume)},
      {"box",
       {{"low", has_box ? point_json(facts.box.low) : Json(nullptr)},
        {"high", has_box ? point_json(facts.box.high) : Json(nullptr)}}},
  };
  return json.dump(2) + "\n";
}

std::string facts_table(const MeshFacts& facts) {
  std::string text;
  const auto line = [&text](const char* name, const std::string& value) {
    text += fmt::format("{:<12}{}\n", name, value);
  };
  line("triangles", fmt::format("{}; {} degenerate ({} with a repeated corner), {} duplicate",
                                facts.triangles, facts.zero_area_triangles,
                                facts.repeated_corner_triangles, facts.duplicate_triangles));
  line("vertices",
       fmt::format("{}; {} not manifold, {} unused, {} contradictory ids", facts.vertices,
                   facts.nonmanifold_vertices, facts.unused_vertices, facts.contradictory_ids));
  line("edges",
       fmt::format("{}; {} boundary, {} not manifold, {} wrongly oriented", facts.edges,
                   facts.boundary_edges, facts.nonmanifold_edges, facts.wrongly_oriented_edges));
  line("rings",
       fmt::format("{}; {} of them simple", facts.boundary_rings, facts.simple_boundary_rings));
  line("components",
       fmt::format("{}; {} closed, {} manifold, {} oriented; the largest has {} triangles",
                   facts.components, facts.closed_components, facts.manifold_components,
                   facts.oriented_components, facts.largest_component_triangles));
  line("euler", std::to_string(facts.euler()));
  line("genus",
       facts.genus() ? fmt::format("{}; {}", *facts.genus(), genus_text(facts)) : "not defined");
  line("area", fmt::format("{}", facts.area));
  line("volume", facts.volume ? fmt::format("{}", *facts.volume) : "not defined");
  if (!facts.box.empty()) {
    const Box3& box = facts.box;
    line("box", fmt::format("{} {} {} to {} {} {}", box.low.x, box.low.y, box.low.z, box.high.x,
                            box.high.y, box.high.z));
  }
  line("closed", yes_no(facts.is_closed()));
  line("manifold", yes_no(facts.is_manifold()));
  line("oriented", yes_no(facts.is_oriented()));
  return text;
}

}  // namespace stream_recon
