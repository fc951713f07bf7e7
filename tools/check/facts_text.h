// The facts of a mesh as JSON and as a table. Keys and numbers: docs/mesh-check.md.
//
// Guarantees: the same facts give the same bytes; JSON numbers read back to the same doubles.
// Thread rule: pure functions.
#pragma once

#include <string>

#include "tools/check/mesh_facts.h"

namespace stream_recon {

/// Indented, with a final newline.
std::string facts_json(const MeshFacts& facts);

/// A few lines for people.
std::string facts_table(const MeshFacts& facts);

}  // namespace stream_recon
