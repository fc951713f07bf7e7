// The points where the edges of a grid cross a value.
//
// An edge joins two cells that are neighbours along an axis; it crosses iff one end is at or above
// the value and the other below. The point is where the linear interpolation between them has the
// value. A cell that has the value exactly is reached by up to six edges and delivered once.
//
// Guarantees: points come in the order of their lowest cell (i fastest), no two are equal as
// doubles (a crossing closer to a cell than 2^-40 of the edge is moved to that distance); cells
// that are not finite cross nothing. Memory: three slices of doubles. Thread rule: one user.
#pragma once

#include <vector>

#include "tools/sampling/grid.h"
#include "tools/sampling/slice_scan.h"

namespace stream_recon {

class IsoScan : public SliceScan {
 public:
  IsoScan(Grid& grid, double value, GridPointConsumer consume);

  bool step() override;

 private:
  void visit(std::size_t i, std::size_t j);
  bool is_lower(double neighbor) const;
  bool has_lower_neighbor(std::size_t i, std::size_t j) const;
  void cross(double a, double b, const Point3& axis, const Point3& cell);
  double fraction(double a, double b) const;

  Grid& grid_;
  double value_;
  GridPointConsumer consume_;
  std::size_t width_, height_, depth_;
  std::vector<double> before_, here_, after_;
  std::size_t k_ = 0;
};

}  // namespace stream_recon
