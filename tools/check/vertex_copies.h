// The vertices of a mesh, each counted once, though chunks repeat those at their borders.
//
// Thread rule: one thread. Memory: what the sort is given; none where vertices come once only.
#pragma once

#include <cstdint>
#include <optional>

#include "engine/order/external_sort.h"
#include "spatial/point.h"
#include "tools/check/mesh_facts.h"

namespace stream_recon {

class VertexCopies {
 public:
  /// \param memory_bytes for sorting; 0: each vertex comes once only \throw BudgetError
  VertexCopies(const StageContext& context, std::uint64_t memory_bytes) {
    if (memory_bytes != 0) sort_.emplace(context, ExternalSortOptions{"vertices", memory_bytes});
  }

  /// \throw IoError
  void add(std::uint64_t number, const Point3& point);
  /// Puts contradictory ids into the facts; the number of different vertices. \throw IoError
  std::uint64_t count(MeshFacts& facts);

 private:
  struct Copy {
    std::uint64_t number = 0;
    Point3 point;

    friend bool operator<(const Copy& a, const Copy& b) {
      return a.number != b.number ? a.number < b.number : a.point < b.point;
    }
  };

  std::optional<ExternalSort<Copy>> sort_;
  std::uint64_t count_ = 0;
};

}  // namespace stream_recon
