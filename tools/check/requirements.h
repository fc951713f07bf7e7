// What a mesh can be required to be, by name.
//
// Thread rule: pure functions.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tools/check/mesh_facts.h"

namespace stream_recon {

/// All names: closed, manifold, oriented, ...
std::vector<std::string> requirement_names();

/// What does not hold, and how many say so: "not closed: 4 boundary edges; ..."; empty if all
/// hold. \throw std::invalid_argument an unknown name
std::string unmet_requirements(const MeshFacts& facts, const std::vector<std::string>& names);

}  // namespace stream_recon
