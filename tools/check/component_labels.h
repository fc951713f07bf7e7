// Which triangles hang together, for a mesh that does not fit in memory.
//
// Triangles come in batches. In a batch, those that share vertices get one label; labels that meet
// later, at a vertex of several batches, are joined. So the memory follows the number of labels,
// which is small where neighbours in the file are neighbours on the surface.
// Guarantees: after resolve(), number_of() is the position of a label's component among all, in the
// order of their first triangles: whatever the memory. Thread rule: one thread. Memory: 4 bytes a
// label, at most one label a triangle. Source: union-find, Tarjan 1975.
#pragma once

#include <cstdint>

#include "engine/budget.h"
#include "spatial/growable_array.h"

namespace stream_recon {

using ComponentLabel = std::uint32_t;

class ComponentLabels {
 public:
  /// \throw BudgetError
  explicit ComponentLabels(MemoryBudget& budget) : memory_(budget.reserve(0, "components")) {}

  /// \throw BudgetError
  ComponentLabel create();
  void join(ComponentLabel a, ComponentLabel b);

  /// No more labels and joins; the number of components.
  std::uint32_t resolve();
  std::uint32_t number_of(ComponentLabel label) const { return parents_[label]; }

 private:
  ComponentLabel root_of(ComponentLabel label);

  Reservation memory_;
  GrowableArray<ComponentLabel> parents_;  ///< never above the label; resolved: the number
  std::uint32_t count_ = 0;
};

}  // namespace stream_recon
