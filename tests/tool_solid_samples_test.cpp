// Samples of known solids: where they lie, how many, and that the same options give the same bits.

#include "tools/clouds/solid_samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include "spatial/vector.h"

namespace stream_recon {
namespace {

std::vector<Point3> points_of(PointSource& source, std::size_t portion = 1000) {
  std::vector<Point3> all;
  std::vector<Point3> buffer(portion);
  while (const std::size_t n = source.read(buffer))
    all.insert(all.end(), buffer.begin(), buffer.begin() + static_cast<std::ptrdiff_t>(n));
  EXPECT_EQ(source.announced_count(), all.size());
  return all;
}

std::vector<Point3> points_of(const SolidSampleOptions& options, std::size_t portion = 1000) {
  return points_of(*sample_solid(options), portion);
}

constexpr std::array kGrids{SolidSampling::kCrossings, SolidSampling::kFaces,
                            SolidSampling::kCentres};

bool is_multiple(double value, double step) {
  return std::remainder(value, step) == 0;
}

/// The voxels of a grid of samples, by their numbers.
class Voxels {
 public:
  Voxels(const KnownSolid& solid, const SampleSpacing& spacing)
      : solid_(solid), spacing_(spacing) {}

  bool inside(const Point3& p) const { return solid_.contains(p); }
  /// The neighbours of a place along an axis, half or a whole voxel away.
  Point3 moved(Point3 p, int axis, double voxels) const {
    const double by = voxels * spacing_.at(static_cast<std::size_t>(axis));
    (axis == 0 ? p.x : axis == 1 ? p.y : p.z) += by;
    return p;
  }
  /// Whether a coordinate is that of a row of voxels.
  bool on_grid(const Point3& p, int axis) const {
    const double value = axis == 0 ? p.x : axis == 1 ? p.y : p.z;
    return is_multiple(value, spacing_.at(static_cast<std::size_t>(axis)));
  }
  int axes_on_grid(const Point3& p) const {
    return static_cast<int>(on_grid(p, 0)) + static_cast<int>(on_grid(p, 1)) +
           static_cast<int>(on_grid(p, 2));
  }

 private:
  const KnownSolid& solid_;
  SampleSpacing spacing_;
};

class SolidGrids : public testing::TestWithParam<std::tuple<std::string_view, std::uint32_t>> {
 protected:
  SolidSampleOptions options(SolidSampling sampling) const {
    const auto& [name, step] = GetParam();
    return {.solid = {std::string(name), 0.2},
            .sampling = sampling,
            .points = 8000,
            .slice_step = step};
  }
  std::unique_ptr<const KnownSolid> solid_ =
      make_solid({std::string(std::get<0>(GetParam())), 0.2});
};

TEST_P(SolidGrids, CountIsCloseToTheOneAskedFor) {
  for (const SolidSampling sampling : kGrids)
    EXPECT_NEAR(static_cast<double>(points_of(options(sampling)).size()), 8000, 400);
}

TEST_P(SolidGrids, CrossingsAreOnGridEdgesAndTheSurface) {
  const auto source = sample_solid(options(SolidSampling::kCrossings));
  const Voxels voxels(*solid_, *source->metadata().spacing);
  for (const Point3& p : points_of(*source)) {
    EXPECT_GE(voxels.axes_on_grid(p), 2);
    EXPECT_LT(std::abs(solid_->signed_bound(p)), 1e-15);
  }
}

TEST_P(SolidGrids, FacesAreBetweenInsideAndOutside) {
  const auto source = sample_solid(options(SolidSampling::kFaces));
  const Voxels voxels(*solid_, *source->metadata().spacing);
  for (const Point3& p : points_of(*source)) {
    ASSERT_EQ(voxels.axes_on_grid(p), 2);
    const int axis = !voxels.on_grid(p, 0) ? 0 : !voxels.on_grid(p, 1) ? 1 : 2;
    EXPECT_NE(voxels.inside(voxels.moved(p, axis, 0.5)),
              voxels.inside(voxels.moved(p, axis, -0.5)));
  }
}

TEST_P(SolidGrids, CentresAreInsideAndHaveAnOutsideNeighbour) {
  const auto source = sample_solid(options(SolidSampling::kCentres));
  const Voxels voxels(*solid_, *source->metadata().spacing);
  for (const Point3& p : points_of(*source)) {
    ASSERT_EQ(voxels.axes_on_grid(p), 3);
    EXPECT_TRUE(voxels.inside(p));
    int outside = 0;
    for (int axis = 0; axis < 3; ++axis)
      for (const double side : {-1.0, 1.0})
        outside += voxels.inside(voxels.moved(p, axis, side)) ? 0 : 1;
    EXPECT_GT(outside, 0);
  }
}

// Nothing is missed: all samples found by asking for every voxel of the box.
TEST_P(SolidGrids, EveryBoundaryVoxelAndFaceIsThere) {
  const auto centres = sample_solid(options(SolidSampling::kCentres));
  const SampleSpacing spacing = *centres->metadata().spacing;
  const Voxels voxels(*solid_, spacing);
  const auto half = static_cast<int>(solid_->reach() / spacing[0]) + 3;
  const auto half_depth = static_cast<int>(solid_->reach() / spacing[2]) + 3;
  std::uint64_t boundary = 0;
  for (int z = -half_depth; z <= half_depth; ++z) {
    for (int y = -half; y <= half; ++y) {
      for (int x = -half; x <= half; ++x) {
        const Point3 p{x * spacing[0], y * spacing[1], z * spacing[2]};
        if (!voxels.inside(p)) continue;
        int outside = 0;
        for (int axis = 0; axis < 3; ++axis)
          for (const double side : {-1.0, 1.0})
            outside += voxels.inside(voxels.moved(p, axis, side)) ? 0 : 1;
        boundary += outside > 0 ? 1 : 0;
      }
    }
  }
  EXPECT_EQ(centres->announced_count(), boundary);
}

INSTANTIATE_TEST_SUITE_P(All, SolidGrids,
                         testing::Combine(testing::ValuesIn(solid_names().begin(),
                                                            solid_names().end()),
                                          testing::Values(1U, 2U, 4U)),
                         [](const auto& test) {
                           return std::string(std::get<0>(test.param)) + "_" +
                                  std::to_string(std::get<1>(test.param));
                         });

TEST(SolidSamples, VoxelsDifferAndAreInScanOrder) {
  const auto points =
      points_of({.solid = {"blob"}, .sampling = SolidSampling::kCentres, .points = 5000});
  for (std::size_t i = 1; i < points.size(); ++i)
    EXPECT_LT(std::tie(points[i - 1].z, points[i - 1].y, points[i - 1].x),
              std::tie(points[i].z, points[i].y, points[i].x));
}

TEST(SolidSamples, CrossingsAndFacesComeInPairs) {
  SolidSampleOptions options{
      .solid = {"torus"}, .sampling = SolidSampling::kCrossings, .points = 5000};
  const auto crossings = points_of(options);
  options.sampling = SolidSampling::kFaces;
  const auto source = sample_solid(options);
  const double pixel = source->metadata().spacing->at(0);
  const auto faces = points_of(*source);
  ASSERT_EQ(crossings.size(), faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i)
    EXPECT_LE(length(minus(crossings[i], faces[i])), 1.5 * pixel + 1e-15);
}

TEST(SolidSamples, PixelsAreExactInFloats) {
  const auto source = sample_solid(
      {.solid = {"folded"}, .sampling = SolidSampling::kFaces, .points = 20000, .slice_step = 2});
  for (const Point3& p : points_of(*source)) {
    EXPECT_EQ(static_cast<double>(static_cast<float>(p.x)), p.x);
    EXPECT_EQ(static_cast<double>(static_cast<float>(p.y)), p.y);
    EXPECT_EQ(static_cast<double>(static_cast<float>(p.z)), p.z);
  }
}

TEST(SolidSamples, NoiseHasTheDeviationAskedForAlongTheNormal) {
  constexpr double kPoints = 20000;
  const auto solid = make_solid({"sphere"});
  const auto points = points_of(
      {.solid = {"sphere"}, .sampling = SolidSampling::kNoisy, .points = 20000, .noise = 0.5});
  double sum = 0;
  double squares = 0;
  for (const Point3& p : points) {
    const double off = length(p) - 1;
    sum += off;
    squares += off * off;
  }
  const double deviation = 0.5 * std::sqrt(solid->truth().area / kPoints);
  EXPECT_NEAR(sum / kPoints, 0, 4 * deviation / std::sqrt(kPoints));
  EXPECT_NEAR(std::sqrt(squares / kPoints), deviation, 0.02 * deviation);
}

TEST(SolidSamples, NoisyWithoutNoiseIsRandom) {
  const SolidSampleOptions options{.solid = {"blob"}, .points = 100};
  SolidSampleOptions noisy = options;
  noisy.sampling = SolidSampling::kNoisy;
  noisy.noise = 0;
  EXPECT_EQ(points_of(options), points_of(noisy));
}

TEST(SolidSamples, PortionsDoNotChangeThePoints) {
  for (const SolidSampling sampling : {SolidSampling::kNoisy, SolidSampling::kCrossings,
                                       SolidSampling::kFaces, SolidSampling::kCentres}) {
    const SolidSampleOptions options{.solid = {"pair"}, .sampling = sampling, .points = 3000};
    EXPECT_EQ(points_of(options, 1), points_of(options, 5000));
  }
}

TEST(SolidSamples, FewPointsAreNoTrouble) {
  for (const SolidSampling sampling : kGrids) {
    for (const std::uint64_t count : {0U, 1U, 10U}) {
      EXPECT_LE(points_of({.solid = {"sphere"}, .sampling = sampling, .points = count}).size(),
                100U);
    }
  }
}

TEST(SolidSamples, WhatIsOutOfRangeIsRefused) {
  EXPECT_THROW(sample_solid({.solid = {"sphere"}, .slice_step = 0}), std::invalid_argument);
  EXPECT_THROW(sample_solid({.solid = {"sphere"}, .slice_step = 1001}), std::invalid_argument);
  EXPECT_THROW(sample_solid({.solid = {"sphere"}, .noise = -1}), std::invalid_argument);
  EXPECT_THROW(sample_solid({.solid = {"sphere"}, .noise = std::nan("")}), std::invalid_argument);
}

}  // namespace
}  // namespace stream_recon
