// How much of space a closed mesh labels wrongly, against a solid whose truth is known.
//
// A straight ray along x goes through each cell of a square grid in y and z, somewhere in it, so
// that none meets a vertex or an edge of a mesh on a lattice. Where a ray meets the mesh, inside
// and outside change. The volume is the length of the parts of rays on which mesh and solid differ,
// times the cell. Thread rule: one thread. Memory: 16 bytes a crossing of a ray and the mesh. Cost:
// about 100 ns a crossing, and 1 us for each of a ray and the solid.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "spatial/point.h"
#include "tools/clouds/known_solid.h"

namespace stream_recon {

struct LabelError {
  double wrong_volume = 0;  ///< symmetric difference of mesh and solid
  double mesh_volume = 0;   ///< inside the mesh by parity
  double solid_volume = 0;  ///< by the same rays: tells how fine they are
  std::uint64_t rays = 0;   ///< that meet the mesh or the solid
  /// That cross the mesh an odd number of times: none if it is closed. They count nowhere else.
  std::uint64_t odd_rays = 0;
};

class LabelErrorMeter {
 public:
  /// \param cell side of the grid's cells, above 0; the solid is looked at in steps of a quarter
  LabelErrorMeter(const KnownSolid& solid, double cell) : solid_(solid), cell_(cell) {}

  void add_triangle(const std::array<Point3, 3>& corners);
  /// No more triangles.
  LabelError measure();

 private:
  struct Crossing {
    std::int32_t z, y;  ///< of the ray's cell
    double x;
  };

  void add_solid_rays();
  void measure_ray(std::span<const Crossing> crossings, LabelError& sum) const;
  std::vector<double> solid_crossings(std::int32_t z, std::int32_t y) const;

  const KnownSolid& solid_;
  double cell_;
  std::vector<Crossing> crossings_;
};

}  // namespace stream_recon
