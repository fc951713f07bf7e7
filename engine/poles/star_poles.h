// The two poles of every sample that a window owns: the vertices of its Voronoi cell that lie
// farthest away, one on either side.
//
// The first pole is the circumcentre of the star that is farthest from the sample, for a sample of
// the hull the point at infinity in the mean direction of its hull facets; the second is the
// farthest of those in the half-space away from the first. Guarantees: a function of the star
// alone, bit for bit: tetrahedra go in by rank, of equally far ones the one of the lowest ranks is
// taken, and normals are added as whole numbers. Thread rule: made by one thread, then const.
// Memory: memory(). Cost: about 100 ns a tetrahedron. Source: Amenta, Bern, Surface Reconstruction
// by Voronoi Filtering, 1999, section 4.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/windows/final_window.h"
#include "spatial/point.h"
#include "spatial/side_evidence.h"

namespace stream_recon {

struct PolePair {
  static constexpr CellId kInfinity = static_cast<CellId>(-1);
  static constexpr CellId kNone = static_cast<CellId>(-2);

  CellId first = kNone;  ///< cell whose circumcentre the pole is; kInfinity at the hull
  CellId second = kNone;
  PoleBalls balls;

  /// Samples of flat stars have one pole at most.
  bool is_complete() const { return first != kNone && second != kNone; }
};

class StarPoles {
 public:
  /// \pre The stars of all owned vertices are final.
  explicit StarPoles(const FinalWindow& window);

  static constexpr std::uint64_t memory(std::uint64_t owned) { return owned * sizeof(Sample); }

  /// Of an owned vertex.
  PolePair pair(VertexId v) const;

 private:
  struct Sample {
    Point3 direction;         ///< towards the first pole, of any length
    double first_square = 0;  ///< of the distance
    double second_square = 0;
    double second_along = 0;  ///< of the second pole in the direction, negative
    CellId first = PolePair::kNone;
    CellId second = PolePair::kNone;
  };

  void find_hull(const FinalWindow& window);
  void find_first(const FinalWindow& window);
  void find_second(const FinalWindow& window);

  std::vector<Sample> samples_;
};

}  // namespace stream_recon
