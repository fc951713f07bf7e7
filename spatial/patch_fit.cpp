#include "spatial/patch_fit.h"

#include <algorithm>
#include <cmath>

#include "spatial/principal_plane.h"
#include "spatial/vector.h"

namespace stream_recon {
namespace {

/// Of more points some do as well.
constexpr std::size_t kMostPoints = 64;

/// h = c0 + c1 u + c2 w + c3 u^2 + c4 u w + c5 w^2
using Coefficients = std::array<double, 6>;

/// The normal equations. Numbers about 1 are expected.
class Quadratic {
 public:
  void add(double u, double w, double h) {
    const std::array<double, kRow> row{1, u, w, u * u, u * w, w * w, h};
    for (std::size_t i = 0; i < kCount; ++i) {
      for (std::size_t j = i; j < kRow; ++j) sums_[i][j] += row[i] * row[j];
    }
  }

  /// Zeros where the points do not tell.
  Coefficients solve() {
    // What few points leave open is to be small.
    for (std::size_t i = 0; i < kCount; ++i) sums_[i][i] += 1e-9 * sums_[0][0];
    for (std::size_t i = 0; i < kCount; ++i) {
      for (std::size_t row = i + 1; row < kCount; ++row) {
        const double factor = sums_[i][row] / sums_[i][i];
        for (std::size_t j = row; j < kRow; ++j) sums_[row][j] -= factor * sums_[i][j];
      }
    }
    Coefficients c{};
    for (std::size_t i = kCount; i-- > 0;) {
      double rest = sums_[i][kCount];
      for (std::size_t j = i + 1; j < kCount; ++j) rest -= sums_[i][j] * c[j];
      c[i] = rest / sums_[i][i];
      if (!std::isfinite(c[i])) return {};
    }
    return c;
  }

 private:
  static constexpr std::size_t kCount = std::tuple_size_v<Coefficients>;
  static constexpr std::size_t kRow = kCount + 1;

  std::array<std::array<double, kRow>, kCount> sums_{};  ///< above the diagonal
};

}  // namespace

Patch fit_patch(std::span<const Point3> all) {
  std::array<Point3, kMostPoints> sample;
  const std::size_t count = std::min(all.size(), sample.size());
  for (std::size_t i = 0; i < count; ++i) sample[i] = all[i * all.size() / count];
  const std::span<const Point3> points(sample.data(), count);
  const double share = 1 / static_cast<double>(points.size());
  Point3 mean{};
  for (const Point3& p : points) mean = plus(mean, p);
  mean = scaled(mean, share);
  Moments moments;
  for (const Point3& p : points) moments.add(minus(p, mean));
  Patch patch;
  patch.middle = mean;
  patch.normal = least_direction(moments);
  const std::array<Point3, 2> axes = across(patch.normal);
  patch.axes = axes;
  const double size = std::sqrt((moments.xx + moments.yy + moments.zz) * share);
  if (!(size > 0) || !std::isfinite(size)) return patch;

  Quadratic quadratic;
  for (const Point3& p : points) {
    const Point3 v = scaled(minus(p, mean), 1 / size);
    quadratic.add(dot(v, axes[0]), dot(v, axes[1]), dot(v, patch.normal));
  }
  const Coefficients c = quadratic.solve();
  // Turned so that u w is gone.
  const double angle = 0.5 * std::atan2(c[4], c[3] - c[5]);
  const double cosine = std::cos(angle);
  const double sine = std::sin(angle);
  patch.axes = {plus(scaled(axes[0], cosine), scaled(axes[1], sine)),
                minus(scaled(axes[1], cosine), scaled(axes[0], sine))};
  const std::array<double, 2> slope{cosine * c[1] + sine * c[2], cosine * c[2] - sine * c[1]};
  const double mixed = cosine * sine * c[4];
  const std::array<double, 2> half{cosine * cosine * c[3] + sine * sine * c[5] + mixed,
                                   sine * sine * c[3] + cosine * cosine * c[5] - mixed};
  // Moved to where the points are as far on one side as on the other.
  double height = c[0];
  for (int i = 0; i < 2; ++i) {
    double low = 0;
    double high = 0;
    for (const Point3& p : points) {
      const double at = dot(minus(p, mean), patch.axes[i]);
      low = std::min(low, at);
      high = std::max(high, at);
    }
    const double to = (low + high) / 2;
    patch.middle = plus(patch.middle, scaled(patch.axes[i], to));
    const double t = to / size;
    height += t * (slope[i] + half[i] * t);
    patch.slope[i] = slope[i] + 2 * half[i] * t;
    patch.curvature[i] = 2 * half[i] / size;
  }
  patch.middle = plus(patch.middle, scaled(patch.normal, height * size));
  return patch;
}

}  // namespace stream_recon
