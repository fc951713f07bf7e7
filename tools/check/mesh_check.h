// Counts what can be wrong with a triangle mesh, however large, in a fixed memory budget.
//
// Guarantees: every number depends on the mesh alone, not on memory or threads; sums of lengths
// and volumes are made in the order of the file. Peak resident memory stays below memory_bytes.
// Memory: at least 40 MB; beside it what a chunk takes (a .pvtp of 100,000 points a chunk about 25
// MB), 4 bytes for each piece of 32,768 triangles that does not hang together (at most a triangle;
// ComponentLabels), 48 bytes a component, 12 bytes a vertex on the boundary, 200 bytes a
// triangle of the largest star. Disk: at most about 150 bytes a triangle, usually a third of it.
// Cost: about 1 us a triangle. Thread rule: one check at a time in a process.
#pragma once

#include <cstdint>
#include <string>

#include "engine/budget.h"
#include "engine/interrupt.h"
#include "tools/check/mesh_facts.h"

namespace stream_recon {

struct MeshCheckOptions {
  std::string path;  ///< .pvtp, .vtp, .ply or .vtk; "-" is PLY on standard input
  std::uint64_t memory_bytes = std::uint64_t{512} << 20;  ///< of the whole process
  unsigned threads = 0;                                   ///< 0: all of the machine
  std::string scratch;          ///< existing folder; empty: $TMPDIR or else /var/tmp
  StopRequest* stop = nullptr;  ///< looked at while the check lasts, if given
};

/// \throw InputError, IoError, BudgetError, Interrupted
MeshFacts check_mesh(const MeshCheckOptions& options);

}  // namespace stream_recon
