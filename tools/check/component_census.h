// What is counted for each component of a mesh, to judge it as a whole.
//
// Counts come while it is not yet known which labels are one component, so they wait on disk.
// Guarantees: sums are made in the order of the triangles in the file. Thread rule: one thread.
// Memory: 48 bytes a component while summing up, and two block files' while collecting.
// Disk, before compression: 16 bytes a triangle and 16 a vertex.
#pragma once

#include <cstdint>

#include "engine/scratch_records.h"
#include "engine/stage_context.h"
#include "tools/check/component_labels.h"
#include "tools/check/mesh_facts.h"

namespace stream_recon {

/// What one vertex adds to its component; of its edges those to higher vertices.
struct VertexNote {
  ComponentLabel label = 0;
  std::uint32_t edges = 0;
  std::uint32_t faults = 0;  ///< of ComponentFault
  std::uint32_t unused = 0;  ///< keeps the record free of padding
};

enum ComponentFault : std::uint32_t {
  kHasBoundary = 1,
  kIsNonmanifold = 2,
  kIsWronglyOriented = 4,
  kIsUnbalanced = 8
};

class ComponentCensus {
 public:
  /// \throw IoError
  explicit ComponentCensus(const StageContext& context);

  /// \throw IoError
  void add_triangle(ComponentLabel label, double volume) { triangles_.append({volume, label}); }
  void add_vertex(const VertexNote& note) { vertices_.append(note); }

  /// Sums up into the facts on components, and the volume. \throw IoError, BudgetError
  void finish(ComponentLabels& labels, MeshFacts& facts);

  static constexpr std::uint64_t memory_bytes() { return 2 * record_file_memory(kBlock); }

 private:
  static constexpr std::size_t kBlock = std::size_t{128} << 10;

  struct TriangleNote {
    double volume = 0;
    ComponentLabel label = 0;
    std::uint32_t unused = 0;
  };

  const StageContext& context_;
  RecordWriter<TriangleNote> triangles_;
  RecordWriter<VertexNote> vertices_;
};

}  // namespace stream_recon
