#include "engine/order/far_points.h"

#include <fmt/format.h>

#include <cmath>

#include "io/error.h"

namespace stream_recon {
namespace {

/// Half the edge of the cube in extents of the box, before it grows to a power of two.
constexpr double kLeastHalfEdge = 2.5;

/// Fifth powers of lengths that are a billionth of the cube's are normal doubles within these.
constexpr double kSmallestCube = 0x1p-140;
constexpr double kLargestCube = 0x1p180;

}  // namespace

std::array<Point3, 8> far_points(const Box3& box) {
  const double extent = box.extent() > 0 ? box.extent() : 1;
  const double half_edge = std::exp2(std::ceil(std::log2(kLeastHalfEdge * extent)));
  if (!(half_edge >= kSmallestCube && half_edge <= kLargestCube)) {
    throw InputError(
        fmt::format("the box of the points is {:g} long, but balls need 1e-40 to 1e50; "
                    "scale the input",
                    extent));
  }
  const double step = half_edge / 8;
  const auto middle = [step](double low, double high) {
    return std::round((low / 2 + high / 2) / step) * step;
  };
  const Point3 centre{middle(box.low.x, box.high.x), middle(box.low.y, box.high.y),
                      middle(box.low.z, box.high.z)};
  std::array<Point3, 8> corners;
  for (unsigned i = 0; i < 8; ++i) {
    corners[i] = {centre.x + ((i & 1) != 0 ? half_edge : -half_edge),
                  centre.y + ((i & 2) != 0 ? half_edge : -half_edge),
                  centre.z + ((i & 4) != 0 ? half_edge : -half_edge)};
  }
  return corners;
}

}  // namespace stream_recon
