#include "tools/check/requirements.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>

namespace stream_recon {
namespace {

/// Empty where the requirement holds.
using Judge = std::string (*)(const MeshFacts&);

std::string counted(const char* failure, std::uint64_t count, const char* what) {
  return count == 0 ? "" : fmt::format("{}: {} {}", failure, count, what);
}

std::string judge_manifold(const MeshFacts& facts) {
  if (facts.is_manifold()) return "";
  return fmt::format("not manifold: {} non-manifold edges, {} non-manifold vertices",
                     facts.nonmanifold_edges, facts.nonmanifold_vertices);
}

constexpr struct {
  std::string_view name;
  Judge judge;
} kRequirements[] = {
    {"closed",
     [](const MeshFacts& f) { return counted("not closed", f.boundary_edges, "boundary edges"); }},
    {"manifold", judge_manifold},
    {"oriented",
     [](const MeshFacts& f) {
       return counted("not oriented", f.wrongly_oriented_edges, "wrongly oriented edges");
     }},
    {"no-degenerate",
     [](const MeshFacts& f) {
       return counted("degenerate", f.zero_area_triangles, "triangles without area");
     }},
    {"no-duplicate",
     [](const MeshFacts& f) {
       return counted("duplicate", f.duplicate_triangles, "triangles that were there already");
     }},
    {"one-component",
     [](const MeshFacts& f) {
       return f.components == 1 ? ""
                                : fmt::format("not one component: {} components", f.components);
     }},
    {"consistent-ids",
     [](const MeshFacts& f) {
       return counted("ids are not consistent", f.contradictory_ids,
                      "ids whose points differ between chunks");
     }},
};

}  // namespace

std::vector<std::string> requirement_names() {
  std::vector<std::string> names;
  for (const auto& requirement : kRequirements) names.emplace_back(requirement.name);
  return names;
}

std::string unmet_requirements(const MeshFacts& facts, const std::vector<std::string>& names) {
  std::string unmet;
  for (const std::string& name : names) {
    const auto* found = std::find_if(std::begin(kRequirements), std::end(kRequirements),
                                     [&](const auto& r) { return r.name == name; });
    if (found == std::end(kRequirements)) {
      throw std::invalid_argument(fmt::format("a mesh cannot be required to be '{}'; known are {}",
                                              name, fmt::join(requirement_names(), ", ")));
    }
    const std::string failure = found->judge(facts);
    if (!failure.empty()) unmet += (unmet.empty() ? "" : "; ") + failure;
  }
  return unmet;
}

}  // namespace stream_recon
