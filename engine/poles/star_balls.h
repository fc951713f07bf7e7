// The circumcentres of all finite tetrahedra with an owned vertex: what the stars of a window see
// of the Voronoi diagram. The tetrahedra are numbered by ascending cell.
//
// Guarantees: with whole stars final, each centre is a function of the tetrahedron's four points
// and the cloud's scale alone, bit for bit, good to 2^-23 of its radius. Thread rule: made by one
// thread, then const. Memory: centre_memory(). Cost: about 40 ns a tetrahedron, flat ones 1 to 20
// us.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/node_set.h"
#include "engine/poles/ranked_cell.h"
#include "engine/windows/final_window.h"
#include "spatial/cell_view.h"
#include "spatial/point.h"
#include "spatial/vector.h"

namespace stream_recon {

class StarBalls {
 public:
  /// \param scale of lengths here over those of the input, a power of two (CloudIndex::scale)
  /// \pre The stars of all owned vertices are final. The window outlives the balls.
  StarBalls(const FinalWindow& window, double scale);

  /// Of the centres of so many cells, besides NodeSet::memory() for all slots.
  static constexpr std::uint64_t centre_memory(std::uint64_t cells) { return cells * sizeof(Ball); }

  /// The finite cells with an owned vertex, numbered.
  const NodeSet& cells() const { return cells_; }
  std::uint32_t count() const { return cells_.count(); }
  /// Infinite cells with an owned vertex.
  std::uint32_t infinite_count() const { return infinite_count_; }

  /// From a corner of cell `number` to its centre, scaled.
  Point3 from(VertexId corner, std::uint32_t number) const {
    const Ball& ball = balls_[number];
    const Point3 centre{ball.centre[0], ball.centre[1], ball.centre[2]};
    return corner == ball.origin ? centre : plus(between(corner, ball.origin), centre);
  }
  /// From one vertex to another, scaled.
  Point3 between(VertexId from, VertexId to) const {
    return scaled(minus(view_.point(to), view_.point(from)), scale_);
  }
  /// Cell `number` is asked about soon.
  void prefetch(std::uint32_t number) const { __builtin_prefetch(&balls_[number]); }
  double scale() const { return scale_; }

  /// The numbers stay.
  void drop_centres() { balls_ = {}; }

 private:
  struct Ball {
    std::array<float, 3> centre;  ///< from the origin, scaled
    VertexId origin;              ///< the corner of lowest rank
  };

  void find_cells(const FinalWindow& window);
  Ball ball_of(const RankedCell& cell) const;

  const CellView view_;
  double scale_;
  NodeSet cells_;
  std::uint32_t infinite_count_ = 0;
  std::vector<Ball> balls_;
};

}  // namespace stream_recon
