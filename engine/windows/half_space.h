// The certificate of an infinite cell: no point of the cloud, not yet in the window, lies beyond
// its hull facet, nor in the facet's plane inside its circumcircle.
//
// Guarantees: as CertificateSearch. Thread rule: a value of one window's.
// Cost: as a ball; of the points in the plane of a flat side of the hull those within or near the
// circle cost an exact test each; where the side is not square to the axes, all of them.
#pragma once

#include <array>
#include <optional>

#include "engine/windows/cloud_index.h"
#include "spatial/ball_list.h"
#include "spatial/flat_circle.h"

namespace stream_recon {

class HalfSpace {
 public:
  struct Height {
    double value;
    double error;
  };

  /// \param facet as the window's points are, counterclockwise from outside
  HalfSpace(const std::array<Point3, 3>& facet, const CloudIndex& index);

  /// Of the points at `least` or more, and at less by what rounding may hide; in a side of the
  /// cloud's box only of those in or near the circle.
  Region at_least(double least, const ListFrame& frame) const;

  /// Over the facet's plane, of a point in the coordinates of the index: so many lengths of the
  /// normal.
  Height height(const Point3& scaled_point) const;

  /// Whether the point is in the facet's plane, exactly, and outside its circumcircle for sure: not
  /// in conflict. Only of planes square to an axis is that known.
  bool is_beside_circle(const Point3& scaled_point) const;

 private:
  bool is_side_of(const Box3& box) const;

  Point3 corner_;           ///< of the facet, scaled
  Point3 corner_relative_;  ///< to the origin of the index
  Point3 normal_;           ///< outward
  double normal_length_;
  double height_error_;  ///< for each unit of a point's distance
  double reach_;
  std::optional<FlatCircle> circle_;
  /// Where no point of the cloud is beyond the plane: all in conflict are here, relative to the
  /// origin of the index.
  std::optional<FlatCircle::Ball> ball_;
};

}  // namespace stream_recon
