// Known solids against their own definitions, measured in other ways.

#include "tools/clouds/known_solid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "spatial/vector.h"

namespace stream_recon {
namespace {

class KnownSolids : public testing::TestWithParam<std::string_view> {
 protected:
  std::unique_ptr<const KnownSolid> solid_ = make_solid({std::string(GetParam()), 0.2});

  std::vector<Point3> surface_points(std::size_t count, std::uint64_t seed = 1) const {
    Random random(seed);
    std::vector<Point3> points;
    while (points.size() < count)
      if (const auto p = solid_->try_surface_point(random)) points.push_back(*p);
    return points;
  }
};

/// Inside and outside on a cubic grid.
class Grid {
 public:
  Grid(const KnownSolid& solid, int half) : half_(half), inside_(volume(), 0) {
    pixel_ = 1.05 * solid.reach() / (half - 1);
    for (int z = -half; z <= half; ++z)
      for (int y = -half; y <= half; ++y)
        for (int x = -half; x <= half; ++x)
          inside_[index({x, y, z})] =
              solid.contains({(x + 0.25) * pixel_, (y + 0.125) * pixel_, z * pixel_});
  }

  double solid_volume() const {
    return pixel_ * pixel_ * pixel_ *
           static_cast<double>(std::count(inside_.begin(), inside_.end(), 1));
  }

  /// Of the surface of the complex of all cells of Kuhn's cutting of cubes into tetrahedra whose
  /// corners are all inside. A cell is a chain of steps from its lowest corner, each along other
  /// axes than the ones before.
  std::int64_t euler() const {
    std::int64_t sum = 0;
    for (int z = -half_; z < half_; ++z)
      for (int y = -half_; y < half_; ++y)
        for (int x = -half_; x < half_; ++x) sum += chains({x, y, z}, 7, 1);
    return 2 * sum;  // a surface has twice the number of what it bounds
  }

 private:
  using Place = std::array<int, 3>;

  std::size_t volume() const {
    const auto side = static_cast<std::size_t>(2 * half_ + 1);
    return side * side * side;
  }
  std::size_t index(const Place& p) const {
    const int side = 2 * half_ + 1;
    return static_cast<std::size_t>(((p[2] + half_) * side + p[1] + half_) * side + p[0] + half_);
  }
  std::int64_t chains(const Place& from, unsigned free_axes, int sign) const {
    if (!inside_[index(from)]) return 0;
    std::int64_t sum = sign;
    for (unsigned step = 1; step <= free_axes; ++step) {
      if ((step & ~free_axes) != 0) continue;
      const Place to{from[0] + static_cast<int>(step & 1),
                     from[1] + static_cast<int>(step >> 1 & 1),
                     from[2] + static_cast<int>(step >> 2)};
      sum += chains(to, free_axes & ~step, -sign);
    }
    return sum;
  }

  int half_;
  std::vector<char> inside_;
  double pixel_ = 0;
};

TEST_P(KnownSolids, EulerNumberAndVolumeAreThoseOfAFineGrid) {
  const Grid grid(*solid_, 60);
  const SolidTruth truth = solid_->truth();
  // Edges as sharp as those of the folded solids crumble on a grid: tool_gyroid_genus_test.cpp.
  const bool has_sharp_edges = GetParam() == "folded" || GetParam() == "sponge";
  if (!has_sharp_edges) {
    EXPECT_EQ(grid.euler(), truth.euler);
  }
  EXPECT_NEAR(grid.solid_volume(), truth.volume, 0.005 * truth.volume);
}

// Points near the surface, thrown into the box: their share is the area times the layer's
// thickness.
TEST_P(KnownSolids, AreaIsThatOfAThinLayer) {
  constexpr double kStep = 1e-3;
  constexpr int kPoints = 400000;
  Random random(3);
  double sum = 0;
  for (int i = 0; i < kPoints; ++i) {
    const Point3 p{solid_->reach() * random.signed_unit(), solid_->reach() * random.signed_unit(),
                   solid_->reach() * random.signed_unit()};
    const Point3 q = plus(p, scaled(random.direction(), kStep));
    if (solid_->contains(p) != solid_->contains(q)) ++sum;
  }
  // A short needle of length l crosses a surface of area A in volume V with probability l A / 2 V.
  const double box = std::pow(2 * solid_->reach(), 3);
  const double area = sum / kPoints * 2 * box / kStep;
  EXPECT_NEAR(area, solid_->truth().area, 4 * area / std::sqrt(sum));
}

TEST_P(KnownSolids, SurfacePointsAreOnTheSurfaceAndInReach) {
  for (const Point3& p : surface_points(2000)) {
    EXPECT_LT(std::abs(solid_->signed_bound(p)), 1e-14);
    EXPECT_LE(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}), solid_->reach() + 1e-14);
  }
}

TEST_P(KnownSolids, NormalsLeaveTheSolid) {
  for (const Point3& p : surface_points(2000)) {
    const Point3 normal = solid_->outward_normal(p);
    EXPECT_NEAR(length(normal), 1, 1e-12);
    EXPECT_FALSE(solid_->contains(plus(p, scaled(normal, 1e-6))));
    EXPECT_TRUE(solid_->contains(minus(p, scaled(normal, 1e-6))));
  }
}

TEST_P(KnownSolids, NormalsAreAcrossTheSurface) {
  Random random(5);
  int strayed = 0;  // over an edge of the folded solid
  for (const Point3& p : surface_points(1000)) {
    const Point3 normal = solid_->outward_normal(p);
    const Point3 across = cross(normal, random.direction());
    for (const double step : {1e-5, -1e-5}) {
      const Point3 q = plus(p, scaled(across, step));
      const bool is_flat = !solid_->contains(plus(q, scaled(normal, 1e-8))) &&
                           solid_->contains(minus(q, scaled(normal, 1e-8)));
      strayed += is_flat ? 0 : 1;
    }
  }
  EXPECT_LE(strayed, 2);
}

TEST_P(KnownSolids, TheBoundReachesNoSurface) {
  Random random(7);
  for (int i = 0; i < 20000; ++i) {
    const double range = 1.5 * solid_->reach();
    const Point3 p{range * random.signed_unit(), range * random.signed_unit(),
                   range * random.signed_unit()};
    const double bound = solid_->signed_bound(p);
    const Point3 q = plus(p, scaled(random.direction(), std::abs(bound) * (1 - 1e-9)));
    EXPECT_EQ(solid_->contains(q), bound < 0);
  }
}

TEST_P(KnownSolids, DensityIsEvenUnlessItIsMeantToBeUneven) {
  const auto points = surface_points(40000, 11);
  const auto share = [&](auto holds) {
    return static_cast<double>(std::count_if(points.begin(), points.end(), holds)) / 40000;
  };
  // The blob and the spherical parts of the folded solids are not the same on both sides.
  if (GetParam() == "blob" || GetParam() == "folded" || GetParam() == "sponge" ||
      GetParam() == "folds")
    return;
  const double right = share([](const Point3& p) { return p.x > 0; });
  if (GetParam() == "uneven")
    EXPECT_LT(right, 0.25);
  else
    EXPECT_NEAR(right, 0.5, 0.01);
}

INSTANTIATE_TEST_SUITE_P(All, KnownSolids,
                         testing::ValuesIn(solid_names().begin(), solid_names().end()),
                         [](const auto& solid) { return std::string(solid.param); });

TEST(KnownSolid, NestedHasThreeSurfacesInTheirShares) {
  const auto solid = make_solid({"nested"});
  Random random(2);
  std::array<int, 3> counts{};
  constexpr int kPoints = 60000;
  for (int i = 0; i < kPoints; ++i) {
    const double radius = length(*solid->try_surface_point(random));
    ++counts.at(radius > 0.9 ? 0 : radius > 0.6 ? 1 : 2);
  }
  const double whole = 1 + 0.49 + 0.16;
  EXPECT_NEAR(counts[0], kPoints / whole, 500);
  EXPECT_NEAR(counts[1], kPoints * 0.49 / whole, 500);
  EXPECT_NEAR(counts[2], kPoints * 0.16 / whole, 500);
}

TEST(KnownSolid, WidthIsTheGapAndTheThickness) {
  const Point3 oblique{2.0 / 7, 3.0 / 7, 6.0 / 7};
  for (const double width : {0.01, 0.3}) {
    const auto pair = make_solid({"pair", width});
    EXPECT_NEAR(pair->signed_bound({0, 0, 0}), width / 2, 1e-15);
    const auto plate = make_solid({"plate", width});
    EXPECT_NEAR(plate->signed_bound({0, 0, 0}), -width / 2, 1e-15);
    EXPECT_NEAR(plate->signed_bound(scaled(oblique, width)), width / 2, 1e-15);
  }
  EXPECT_NEAR(make_solid({"pair"})->signed_bound({0, 0, 0}), 0.025, 1e-15);
}

TEST(KnownSolid, WhatIsNoneIsRefused) {
  EXPECT_THROW(make_solid({"cube"}), std::invalid_argument);
  EXPECT_THROW(make_solid({"pair", -0.1}), std::invalid_argument);
  EXPECT_THROW(make_solid({"plate", 1}), std::invalid_argument);
  EXPECT_THROW(make_solid({"plate", std::nan("")}), std::invalid_argument);
}

}  // namespace
}  // namespace stream_recon
