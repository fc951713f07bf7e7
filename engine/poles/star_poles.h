// The two poles of every sample that a window owns: the vertices of its Voronoi cell that lie
// farthest away, one on either side.
//
// The first pole is the circumcentre of the star that is farthest from the sample, for a sample of
// the hull the point at infinity in the mean direction of its hull facets; the second is the
// farthest of those in the half-space away from the first. Guarantees: a function of the star
// alone, bit for bit: of equally far ones the one of the lowest ranks is taken, and normals are
// added as whole numbers. Thread rule: made by one thread, then const.
// Memory: memory(). Cost: about 60 ns a tetrahedron. Source: Amenta, Bern, Surface Reconstruction
// by Voronoi Filtering, 1999, section 4.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/poles/star_balls.h"
#include "engine/windows/final_window.h"
#include "spatial/point.h"
#include "spatial/side_evidence.h"

namespace stream_recon {

struct PolePair {
  static constexpr CellId kInfinity = static_cast<CellId>(-1);
  static constexpr CellId kNone = static_cast<CellId>(-2);

  CellId first = kNone;  ///< cell whose circumcentre the pole is; kInfinity at the hull
  CellId second = kNone;

  /// Samples of flat stars have one pole at most.
  bool is_complete() const { return first != kNone && second != kNone; }
};

class StarPoles {
 public:
  /// \pre The balls are those of the window.
  StarPoles(const FinalWindow& window, const StarBalls& balls);

  static constexpr std::uint64_t memory(std::uint64_t owned) { return owned * sizeof(Sample); }

  /// Of an owned vertex.
  PolePair pair(VertexId v) const { return samples_[v].poles; }
  /// The vertex is no sample and has none.
  void forget(VertexId v) { samples_[v].poles = {}; }
  /// How its balls stand to each other, scaled as `balls` is. \pre the pair is complete
  PoleBalls balls_of(VertexId v, const StarBalls& balls) const;

 private:
  struct Sample {
    Point3 direction;   ///< towards the first pole, of any length
    double square = 0;  ///< of the distance of the pole that is looked for, so far
    PolePair poles;
  };

  void find_hull(const FinalWindow& window);
  void find_first(const FinalWindow& window, const StarBalls& balls);
  void find_second(const FinalWindow& window, const StarBalls& balls);

  std::vector<Sample> samples_;
};

}  // namespace stream_recon
