// From voxels to points: objects, their boundaries, regions, offsets, labels.
#include "tools/sampling/sampling.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>

#include "io/error.h"
#include "tests/array_volume.h"
#include "tests/io_test_folder.h"
#include "tools/sampling/blurred_grid.h"
#include "tools/sampling/each_label.h"

namespace stream_recon {
namespace {

using testing::HasSubstr;
using Points = std::vector<Point3>;
using PointSet = std::set<std::array<double, 3>>;

constexpr std::array<std::array<long, 3>, 6> kFaces{
    {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};

SamplingOptions options_of(PointKind kind, const VoxelSelection& selection, double sigma = 0) {
  SamplingOptions options;
  options.kind = kind;
  options.selection = selection;
  options.smoothing.sigma = sigma;
  return options;
}

Points sampled(Volume& volume, const SamplingOptions& options) {
  Points points;
  Sampling sampling(volume, options);
  const SampleCounts counts = sampling.run([&](const Point3& p) { points.push_back(p); });
  EXPECT_EQ(counts.points, points.size());
  return points;
}

PointSet as_set(const Points& points) {
  PointSet set;
  for (const Point3& p : points) {
    EXPECT_TRUE(set.insert({p.x, p.y, p.z}).second) << "repeated";
  }
  return set;
}

ArrayVolume random_labels(std::mt19937& random, unsigned labels) {
  const auto side = [&] { return std::size_t{1 + random() % 6}; };
  return ArrayVolume::made({side(), side(), side()}, [&](auto, auto, auto) {
    return static_cast<double>(random() % (labels + 1));
  });
}

/// Every pair of a cell of the object and a face neighbour outside.
template <typename Visit>
void visit_boundary_faces(const ArrayVolume& volume, double label, Visit visit) {
  const auto& size = volume.geometry().size;
  for (long k = 0; k < static_cast<long>(size[2]); ++k)
    for (long j = 0; j < static_cast<long>(size[1]); ++j)
      for (long i = 0; i < static_cast<long>(size[0]); ++i)
        for (const auto& step : kFaces) {
          if (volume.at_or({i, j, k}, 0) != label) continue;
          if (volume.at_or({i + step[0], j + step[1], k + step[2]}, 0) == label) continue;
          visit(std::array<double, 3>{double(i), double(j), double(k)}, step);
        }
}

TEST(BoundaryVoxels, AreTheObjectsVoxelsWithAFaceNeighbourOutside) {
  for (unsigned seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    ArrayVolume volume = random_labels(random, 2);
    PointSet expected;
    visit_boundary_faces(volume, 1, [&](const auto& cell, const auto&) { expected.insert(cell); });
    if (expected.empty()) continue;
    EXPECT_EQ(as_set(sampled(
                  volume, options_of(PointKind::kBoundaryVoxels, VoxelSelection::of_labels({1})))),
              expected);
  }
}

// One crossing on each boundary face: topology is the mask's, whatever the smoothing.
TEST(SmoothedBoundary,
     ThatKeepsThinPartsCrossesEveryFaceBetweenInsideAndOutsideOnceAndNothingElse) {
  for (unsigned seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    ArrayVolume volume = random_labels(random, 2);
    const double sigma = std::array{0.0, 0.3, 1.0, 2.5}[seed % 4];
    std::map<std::array<double, 3>, int> edges;  // by the doubled middle
    visit_boundary_faces(volume, 1, [&](const auto& cell, const auto& step) {
      ++edges[{2 * cell[0] + double(step[0]), 2 * cell[1] + double(step[1]),
               2 * cell[2] + double(step[2])}];
    });
    if (edges.empty()) continue;
    SamplingOptions options =
        options_of(PointKind::kSmoothedBoundary, VoxelSelection::of_labels({1}), sigma);
    options.smoothing.keep_thin = true;
    for (const Point3& p : sampled(volume, options)) {
      std::array<double, 3> middle{};
      int fractions = 0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double x = std::array{p.x, p.y, p.z}[axis];
        const double below = std::floor(x);
        middle[axis] = 2 * below;
        if (x == below) continue;
        ++fractions;
        middle[axis] = 2 * below + 1;
        EXPECT_GE(x - below, 0.1);
        EXPECT_LE(x - below, 0.9);
      }
      EXPECT_EQ(fractions, 1);
      EXPECT_EQ(--edges[middle], 0) << p.x << " " << p.y << " " << p.z;
    }
    for (const auto& [middle, left] : edges) EXPECT_EQ(left, 0);
  }
}

TEST(SmoothedBoundary, CountsTheVoxelsThatSmoothingMovesAcross) {
  // A sheet one voxel thick, and a block that has a dent.
  ArrayVolume volume = ArrayVolume::made({12, 12, 20}, [](auto i, auto j, auto k) {
    return k == 3 || (k >= 9 && k < 17 && !(i == 6 && j == 6 && k == 16)) ? 1.0 : 0.0;
  });
  Sampling sampling(volume,
                    options_of(PointKind::kSmoothedBoundary, VoxelSelection::any_label(), 1));
  double lowest = HUGE_VAL;
  for (int pass = 0; pass < 2; ++pass) {
    const SampleCounts counts =
        sampling.run([&](const Point3& p) { lowest = std::min(lowest, p.z); });
    EXPECT_EQ(counts.voxels, 12U * 12 * 9 - 1);
    EXPECT_GE(counts.voxels_lost, 12U * 12);  // the sheet, and corners of the block
    EXPECT_LE(counts.voxels_lost, 12U * 12 + 8 * 12 + 4 * 8);
    EXPECT_EQ(counts.voxels_gained, 1U);
  }
  EXPECT_GT(lowest, 8);
}

TEST(SmoothedBoundary, OfWhatIsAllTooThinIsRefused) {
  ArrayVolume sheet =
      ArrayVolume::made({8, 8, 9}, [](auto, auto, auto k) { return k == 4 ? 1 : 0; });
  SamplingOptions options =
      options_of(PointKind::kSmoothedBoundary, VoxelSelection::any_label(), 1);
  try {
    sampled(sheet, options);
    ADD_FAILURE() << "not refused";
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), HasSubstr("all 64 voxels"));
    EXPECT_THAT(e.what(), HasSubstr("--keep-thin"));
  }
  options.smoothing.keep_thin = true;
  EXPECT_EQ(sampled(sheet, options).size(), 2U * 64 + 4 * 8);
}

TEST(SmoothedBoundary, OfABallLiesCloserToItThanVoxelFacesDo) {
  const double radius = 17.3;
  const Point3 center{20.2, 19.7, 20.4};
  const auto distance = [&](double x, double y, double z) {
    return std::hypot(x - center.x, y - center.y, z - center.z) - radius;
  };
  ArrayVolume ball = ArrayVolume::made({41, 41, 41}, [&](double i, double j, double k) {
    return distance(i, j, k) <= 0 ? 1.0 : 0.0;
  });
  std::map<double, double> error;
  for (const double sigma : {0.0, 1.0}) {
    const Points points =
        sampled(ball, options_of(PointKind::kSmoothedBoundary, VoxelSelection::any_label(), sigma));
    double sum = 0;
    for (const Point3& p : points) sum += std::pow(distance(p.x, p.y, p.z), 2);
    error[sigma] = std::sqrt(sum / static_cast<double>(points.size()));
  }
  EXPECT_LT(error[1.0], 0.13);
  EXPECT_LT(error[1.0], error[0.0] / 2);
}

TEST(Objects, ThatFillTheVolumeAreClosedAtItsEdge) {
  ArrayVolume full = ArrayVolume::made({3, 4, 5}, [](auto, auto, auto) { return 9.0; });
  const auto points =
      sampled(full, options_of(PointKind::kSmoothedBoundary, VoxelSelection::at_least(9)));
  EXPECT_EQ(points.size(), 2U * (3 * 4 + 4 * 5 + 3 * 5));
  EXPECT_EQ(sampled(full, options_of(PointKind::kBoundaryVoxels, VoxelSelection::above(8))).size(),
            3U * 4 * 5 - 1 * 2 * 3);
}

TEST(Objects, AreWhatTheSelectionSays) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  ArrayVolume row({9, 1, 1},
                  {-1, 0, 1, 2, 3, nan, 0.5, std::numeric_limits<double>::infinity(), 7});
  const auto inside = [&](const VoxelSelection& selection) {
    std::vector<double> at;
    for (const Point3& p : sampled(row, options_of(PointKind::kBoundaryVoxels, selection))) {
      at.push_back(p.x);
    }
    return at;
  };
  using At = std::vector<double>;
  EXPECT_EQ(inside(VoxelSelection::above(1)), (At{3, 4, 8}));
  EXPECT_EQ(inside(VoxelSelection::at_least(1)), (At{2, 3, 4, 8}));
  EXPECT_EQ(inside(VoxelSelection::any_label()), (At{0, 2, 3, 4, 6, 8}));
  EXPECT_EQ(inside(VoxelSelection::of_labels({7, 1})), (At{2, 8}));
  EXPECT_EQ(inside(VoxelSelection::of_labels({-1})), (At{0}));
}

TEST(Objects, ThatAreNotThereAreRefusedWithWhatIs) {
  ArrayVolume row({3, 1, 1}, {1, 5, 2});
  for (const PointKind kind : {PointKind::kBoundaryVoxels, PointKind::kSmoothedBoundary}) {
    try {
      sampled(row, options_of(kind, VoxelSelection::of_labels({4})));
      ADD_FAILURE() << "not refused";
    } catch (const InputError& e) {
      EXPECT_THAT(e.what(), HasSubstr("no voxel has label 4; labels here: 1 to 2, 5"));
    }
  }
  SamplingOptions iso;
  iso.iso = 6;
  try {
    sampled(row, iso);
    ADD_FAILURE() << "not refused";
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), HasSubstr("the voxels hold 1 to 5"));
  }
}

// The points of a part are those of the whole that lie on its edges, bit for bit.
TEST(Regions, GiveThePointsOfTheWholeThatLieInThem) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    ArrayVolume volume = ArrayVolume::made(
        {7, 6, 8}, [&](auto, auto, auto) { return static_cast<double>(random() % 100); });
    volume.change().origin = {0.1, -3, 1e3};
    volume.change().step = {{{0.3, 0.1, 0}, {0, 0.7, 0.2}, {0.01, 0, 1.9}}};
    SamplingOptions options;
    options.iso = 41.5;
    SamplingOptions whole_options = options;
    options.region = parse_region("2:6,:5,3:");
    const PointSet whole = as_set(sampled(volume, whole_options));
    const PointSet part = as_set(sampled(volume, options));
    for (const auto& p : part) EXPECT_TRUE(whole.count(p));
    options.coordinates = CoordinateSystem::kIndex;
    for (const Point3& p : sampled(volume, options)) {
      EXPECT_TRUE(p.x >= 2 && p.x <= 5 && p.y >= 0 && p.y <= 4 && p.z >= 3 && p.z <= 7);
    }
    std::size_t expected = 0;
    whole_options.coordinates = CoordinateSystem::kIndex;
    for (const Point3& p : sampled(volume, whole_options)) {
      expected += p.x >= 2 && p.x <= 5 && p.y >= 0 && p.y <= 4 && p.z >= 3 && p.z <= 7 ? 1 : 0;
    }
    EXPECT_EQ(part.size(), expected);
  }
}

TEST(Regions, OfEveryNthVoxelKeepTheirPlaces) {
  ArrayVolume volume = ArrayVolume::made(
      {10, 9, 8}, [](double i, double j, double k) { return i == 4 && j == 6 && k == 3 ? 1 : 0; });
  volume.change().step[2] = {0, 0, 1.5};
  SamplingOptions options = options_of(PointKind::kBoundaryVoxels, VoxelSelection::any_label());
  options.every = {2, 3, 3};
  EXPECT_EQ(sampled(volume, options), (Points{{4, 6, 4.5}}));
  EXPECT_EQ(Sampling(volume, options).metadata("").spacing, (SampleSpacing{2, 3, 4.5}));
  options.coordinates = CoordinateSystem::kIndex;
  EXPECT_EQ(Sampling(volume, options).metadata("").spacing, (SampleSpacing{2, 3, 3}));
  options.every = {3, 3, 3};  // passes the voxel by
  EXPECT_THROW(sampled(volume, options), InputError);
}

TEST(Regions, AreReadOrRefused) {
  const RegionOfInterest region = parse_region("1:20,:,:7");
  EXPECT_EQ(box_of(region, {20, 5, 9}).high, (GridSize{20, 5, 7}));
  for (const char* text :
       {"", "1", "1:2", "1:2,3:4", "a:2,:,:", "1:2,:,:,:", "-1:2,:,:", "1:2:3,:,:"}) {
    EXPECT_THROW(parse_region(text), std::invalid_argument) << text;
  }
  EXPECT_THROW(box_of(parse_region("5:5,:,:"), {9, 9, 9}), std::invalid_argument);
  EXPECT_THROW(box_of(parse_region(":,:10,:"), {9, 9, 9}), std::invalid_argument);
}

// A stack that slipped, and the offsets that put it right again.
TEST(Offsets, PutASlippedStackBackInPlace) {
  const auto ball = [](double i, double j, double k) {
    return std::hypot(i - 9, j - 9, k - 6) < 5 ? 1.0 : 0.0;
  };
  ArrayVolume straight = ArrayVolume::made({20, 20, 13}, ball);
  std::mt19937 random(5);
  std::vector<SliceOffset> offsets(13);
  for (SliceOffset& offset : offsets) {
    offset = {double(random() % 7) - 3, double(random() % 7) - 3};
  }
  ArrayVolume slipped = ArrayVolume::made({20, 20, 13}, [&](double i, double j, std::size_t k) {
    return ball(i + offsets[k].di, j + offsets[k].dj, double(k));
  });
  for (const PointKind kind : {PointKind::kBoundaryVoxels, PointKind::kSmoothedBoundary}) {
    SamplingOptions options = options_of(kind, VoxelSelection::any_label(), 1);
    const Points expected = sampled(straight, options);
    options.offsets = offsets;
    EXPECT_EQ(sampled(slipped, options), expected);
  }
}

TEST(Offsets, OfPartsOfAVoxelMovePointsAndAreInterpolatedBetweenSlices) {
  ArrayVolume column({1, 1, 3}, {0, 4, 8});
  SamplingOptions options;
  options.iso = 1;
  options.offsets = {{0.25, -0.4}, {-0.25, 0.4}, {0, 0}};
  const Points points = sampled(column, options);
  ASSERT_EQ(points.size(), 1U);
  EXPECT_NEAR(points[0].x, 0.125, 1e-12);
  EXPECT_NEAR(points[0].y, -0.2, 1e-12);
  EXPECT_EQ(points[0].z, 0.25);
}

TEST(Offsets, AreReadOrRefusedWithTheLine) {
  const TestFolder folder;
  const auto read = [&](const std::string& text) {
    put_bytes(folder / "offsets", text);
    return read_slice_alignment(folder / "offsets", 5);
  };
  const auto offsets = read("# slice di dj\n1 0.5 -2\n\n 4,1e1,0 # last\r\n");
  ASSERT_EQ(offsets.size(), 5U);
  EXPECT_EQ(offsets[1].di, 0.5);
  EXPECT_EQ(offsets[1].dj, -2);
  EXPECT_EQ(offsets[4].di, 10);
  EXPECT_EQ(offsets[0].di, 0);
  for (const char* text : {"5 0 0", "-1 0 0", "1.5 0 0", "1 2", "1 2 x", "1 2 3 4", "1 nan 0",
                           "1 1e9 0", "2 0 0\n2 0 0"}) {
    try {
      read(text);
      ADD_FAILURE() << "not refused: " << text;
    } catch (const InputError& e) {
      EXPECT_THAT(e.what(), HasSubstr(std::string("line ") + (text[0] == '2' ? "2" : "1")));
    }
  }
  EXPECT_THROW(read_slice_alignment(folder / "missing", 5), IoError);
}

/// All of a grid.
std::vector<double> cells_of(Grid& grid) {
  std::vector<double> all;
  std::vector<double> slice(grid.slice_cells());
  for (std::size_t k = 0; k < grid.size()[2]; ++k) {
    grid.read_slice(k, slice);
    all.insert(all.end(), slice.begin(), slice.end());
  }
  return all;
}

TEST(BlurredGrid, IsTheGaussianMeanOfTheKnownCells) {
  std::mt19937 random(3);
  const GridSize size{6, 5, 7};
  ArrayVolume volume = ArrayVolume::made(size, [&](auto, auto, auto) {
    return random() % 9 == 0 ? std::nan("") : static_cast<double>(random() % 100);
  });
  RegionGrid grid(volume, {{0, 0, 0}, size}, {1, 1, 1});
  for (const double sigma : {0.5, 1.0, 3.0}) {
    BlurredGrid blurred(grid, sigma, BeyondEdge::kIgnored);
    const std::vector<double> found = cells_of(blurred);
    const auto radius = static_cast<long>(blur_radius(sigma));
    std::size_t at = 0;
    for (long k = 0; k < 7; ++k)
      for (long j = 0; j < 5; ++j)
        for (long i = 0; i < 6; ++i, ++at) {
          double sum = 0;
          double weight = 0;
          for (long c = -radius; c <= radius; ++c)
            for (long b = -radius; b <= radius; ++b)
              for (long a = -radius; a <= radius; ++a) {
                const double value = volume.at_or({i + a, j + b, k + c}, std::nan(""));
                if (!std::isfinite(value)) continue;
                const double w = std::exp(-double(a * a + b * b + c * c) / (2 * sigma * sigma));
                sum += w * value;
                weight += w;
              }
          if (std::isfinite(volume.at_or({i, j, k}, 0))) {
            EXPECT_NEAR(found[at], sum / weight, 1e-3);
          } else {
            EXPECT_TRUE(std::isnan(found[at]));
          }
        }
  }
}

class Collected : public LabelSink {
 public:
  explicit Collected(Points& points) : points_(points) {}
  void take(const Point3& point) override { points_.push_back(point); }
  void finish(const SampleCounts& counts) override { EXPECT_EQ(counts.points, points_.size()); }

 private:
  Points& points_;
};

TEST(EachLabel, GivesEveryLabelThePointsItHasByItself) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    // More labels than are walked at once, in one case of two.
    const unsigned labels = seed % 2 == 0 ? 3 : 300;
    ArrayVolume volume = ArrayVolume::made(
        {9, 8, 11}, [&](auto, auto, auto) { return static_cast<double>(random() % (labels + 1)); });
    SamplingOptions options =
        options_of(seed % 3 == 0 ? PointKind::kBoundaryVoxels : PointKind::kSmoothedBoundary,
                   VoxelSelection::any_label(), seed % 3 == 1 ? 1 : 0.0);
    options.smoothing.keep_thin = seed % 4 < 2;
    std::map<double, Points> found;
    const std::size_t count = sample_each_label(
        volume, options, [&](double label) { return std::make_unique<Collected>(found[label]); });
    EXPECT_EQ(count, found.size());
    for (const auto& [label, points] : found) {
      if (points.empty()) continue;  // smoothed away, which finish() saw
      options.selection = VoxelSelection::of_labels({label});
      EXPECT_EQ(points, sampled(volume, options)) << "label " << label;
    }
  }
}

TEST(EachLabel, WantsWholeNumbersAndNotTooManyOfThem) {
  const auto make_sink = [](double) -> std::unique_ptr<LabelSink> { return nullptr; };
  const SamplingOptions options =
      options_of(PointKind::kBoundaryVoxels, VoxelSelection::any_label());
  ArrayVolume grey({2, 1, 1}, {1, 1.5});
  EXPECT_THROW(sample_each_label(grey, options, make_sink), InputError);
  ArrayVolume empty({2, 1, 1}, {0, 0});
  EXPECT_THROW(sample_each_label(empty, options, make_sink), InputError);
  double next = 0;
  ArrayVolume many = ArrayVolume::made({300, 300, 1}, [&](auto, auto, auto) { return next++; });
  EXPECT_THROW(sample_each_label(many, options, make_sink), InputError);
}

TEST(LabelList, ShowsRuns) {
  std::vector<LabelExtent> labels;
  for (const double label : {1, 2, 3, 7, 9, 10}) labels.push_back({label, 1, {}});
  EXPECT_EQ(label_list(labels), "1 to 3, 7, 9 to 10");
  EXPECT_EQ(label_list({}), "none");
}

}  // namespace
}  // namespace stream_recon
