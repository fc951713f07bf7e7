#include "tools/check/component_labels.h"

#include <limits>
#include <utility>

namespace stream_recon {

ComponentLabel ComponentLabels::create() {
  constexpr std::size_t kStep = std::size_t{1} << 14;
  if (count_ == std::numeric_limits<ComponentLabel>::max()) {
    throw BudgetError("more than 2^32 pieces that do not hang together; split the mesh");
  }
  if (count_ == parents_.capacity()) {
    memory_.resize((count_ + kStep) * sizeof(ComponentLabel));
    parents_.reserve(count_ + kStep);
  }
  parents_[count_] = count_;
  return count_++;
}

ComponentLabel ComponentLabels::root_of(ComponentLabel label) {
  while (parents_[label] != label) {
    parents_[label] = parents_[parents_[label]];
    label = parents_[label];
  }
  return label;
}

void ComponentLabels::join(ComponentLabel a, ComponentLabel b) {
  a = root_of(a);
  b = root_of(b);
  if (a > b) std::swap(a, b);
  parents_[b] = a;
}

std::uint32_t ComponentLabels::resolve() {
  std::uint32_t components = 0;
  for (ComponentLabel label = 0; label < count_; ++label) {
    const ComponentLabel parent = parents_[label];
    parents_[label] = parent == label ? components++ : parents_[parent];
  }
  return components;
}

}  // namespace stream_recon
