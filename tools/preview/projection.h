// Where a point of a view's coordinates is on a screen that shows all of a box.
//
// Thread rule: a value.
#pragma once

#include "spatial/box.h"
#include "tools/preview/depth_buffer.h"

namespace stream_recon {

class Projection {
 public:
  Projection(const Box3& box, const DepthBuffer& screen);

  Vector3f operator()(const Point3& p) const;
  /// Samples a unit of length takes.
  double scale() const { return scale_; }

 private:
  Point3 center_;
  double half_width_;
  double half_height_;
  double scale_ = 1;
};

}  // namespace stream_recon
