#include "tools/check/vertex_copies.h"

namespace stream_recon {

void VertexCopies::add(std::uint64_t number, const Point3& point) {
  if (sort_) {
    sort_->add({number, point});
  } else {
    ++count_;
  }
}

std::uint64_t VertexCopies::count(MeshFacts& facts) {
  if (!sort_) return count_;
  std::optional<Copy> first;
  bool is_contradictory = false;
  sort_->for_each([&](const Copy& copy) {
    if (first && copy.number == first->number) {
      if (!is_contradictory && !(copy.point == first->point)) {
        is_contradictory = true;
        ++facts.contradictory_ids;
      }
      return;
    }
    first = copy;
    is_contradictory = false;
    ++count_;
  });
  return count_;
}

}  // namespace stream_recon
