// A facet of a window with its vertices by ascending rank: the order in which every window sees it.
//
// Thread rule: a value.
#pragma once

#include <array>
#include <utility>

#include "engine/windows/final_window.h"

namespace stream_recon {

struct RankedFacet {
  std::array<VertexId, 3> vertices;
  std::array<PointRank, 3> ranks;
  bool reversed = false;  ///< an odd permutation of the order it was given in

  RankedFacet(const FinalWindow& window, const std::array<VertexId, 3>& v)
      : vertices(v), ranks{window.rank(v[0]), window.rank(v[1]), window.rank(v[2])} {
    order(0, 1);
    order(1, 2);
    order(0, 1);
  }

 private:
  void order(int i, int j) {
    if (ranks[i] < ranks[j]) return;
    std::swap(ranks[i], ranks[j]);
    std::swap(vertices[i], vertices[j]);
    reversed = !reversed;
  }
};

}  // namespace stream_recon
