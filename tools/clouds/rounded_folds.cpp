#include "tools/clouds/rounded_folds.h"

#include <algorithm>
#include <cmath>

#include "spatial/vector.h"
#include "tools/clouds/folded_solid.h"
#include "tools/clouds/trigonometry.h"

namespace stream_recon {
namespace {

constexpr double kWave = 2.9 * kPi;  ///< radians a unit of length
constexpr double kRounding = 0.06;
/// Between the gyroid's least and largest slope on its surface, in waves: its sum becomes nearly a
/// distance.
constexpr double kSlope = 1.2;
/// Of the value below, anywhere: sqrt(3) waves are the gyroid's.
constexpr double kSteepest = 1.7320508075688774 / kSlope;
constexpr double kHalfThickness = 0.01;

struct Field {
  double value;  ///< negative inside
  Point3 gradient;
};

Field field_at(const Point3& p) {
  const GyroidField gyroid = gyroid_field(p, kWave);
  const double distance = length(p);
  const double folds = gyroid.value / (kWave * kSlope);
  const double ball = distance - 1;
  const double overlap = std::max(kRounding - std::abs(folds - ball), 0.0) / kRounding;
  const double rounding = overlap * overlap * kRounding / 4;
  const double weaker = overlap / 2;
  const double share = folds > ball ? 1 - weaker : weaker;
  const Point3 along_folds = scaled(gyroid.gradient, share / (kWave * kSlope));
  // At the origin only the gyroid counts.
  const Point3 along_ball = share == 1 ? Point3{0, 0, 0} : scaled(p, (1 - share) / distance);
  return {std::max(folds, ball) + rounding, plus(along_folds, along_ball)};
}

}  // namespace

double RoundedFolds::signed_bound(const Point3& p) const {
  return field_at(p).value / kSteepest;
}

Point3 RoundedFolds::outward_normal(const Point3& p) const {
  const Point3 gradient = field_at(p).gradient;
  return scaled(gradient, 1 / length(gradient));
}

// As of the gyroid's part of the folded solid: points of a thin layer, moved onto the surface.
std::optional<Point3> RoundedFolds::try_surface_point(Random& random) const {
  constexpr double kHalfBox = 1 + kHalfThickness;
  const Point3 start{kHalfBox * random.signed_unit(), kHalfBox * random.signed_unit(),
                     kHalfBox * random.signed_unit()};
  Field field = field_at(start);
  if (std::abs(field.value) > 1.5 * kHalfThickness * length(field.gradient)) return std::nullopt;
  Point3 p = start;
  for (int step = 0; step < 6; ++step) {
    p = minus(p, scaled(field.gradient, field.value / dot(field.gradient, field.gradient)));
    field = field_at(p);
  }
  if (length(minus(p, start)) > kHalfThickness || std::abs(field.value) > 1e-14) {
    return std::nullopt;
  }
  return p;
}

}  // namespace stream_recon
