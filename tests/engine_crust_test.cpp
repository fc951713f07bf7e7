// The power crust of a run: closed, near the truth, through the samples, and the same bytes however
// the run is cut.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <optional>
#include <ostream>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "engine/reconstruct.h"
#include "io/mesh_source.h"
#include "spatial/vector.h"
#include "tests/full_disks.h"
#include "tests/io_test_folder.h"
#include "tests/point_families.h"

namespace stream_recon {
namespace {

using testing::HasSubstr;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kIsSlow = true;  // each takes ten times as long
#else
constexpr bool kIsSlow = false;
#endif

constexpr double kPi = std::numbers::pi;

using Cloud = std::vector<Point3>;

std::string write_cloud(const TestFolder& folder, const Cloud& cloud) {
  put_bytes(folder / "cloud.f64",
            {reinterpret_cast<const char*>(cloud.data()), cloud.size() * sizeof(Point3)});
  return folder / "cloud.f64";
}

RunOptions options_for(const TestFolder& folder, const Cloud& cloud) {
  RunOptions options;
  options.inputs = {write_cloud(folder, cloud)};
  options.input_format = InputFormat::kF64;
  options.surface = SurfaceKind::kCrust;
  options.output = folder / "out.pvtp";
  options.memory_bytes = std::uint64_t{512} << 20;
  options.threads = 1;
  options.chunk_points = 700;
  return options;
}

/// All that the power diagram gives.
RunOptions options_for_all(const TestFolder& folder, const Cloud& cloud) {
  RunOptions options = options_for(folder, cloud);
  options.medial_axis = folder / "axis.pvtp";
  options.medial_axis_faces = true;
  return options;
}

/// All bytes of both chunked outputs.
std::string output_bytes(const TestFolder& folder) {
  std::string all;
  for (const std::string output : {"out", "axis"}) {
    all += file_bytes(folder / (output + ".pvtp"));
    for (const std::string& chunk : list_folder(folder / output)) {
      all += chunk + file_bytes(folder / (output + "/" + chunk));
    }
  }
  return all;
}

Point3 direction(std::mt19937_64& random) {
  for (;;) {
    const Point3 p = families::random_point(random);
    const double size = length(p);
    if (size > 0.01 && size <= 1) return scaled(p, 1 / size);
  }
}

Cloud from_parameters(std::size_t count, const std::function<Point3(std::mt19937_64&)>& point) {
  std::mt19937_64 random(41);
  Cloud cloud;
  for (std::size_t i = 0; i < count; ++i) cloud.push_back(point(random));
  return cloud;
}

/// An ellipsoid: on a sphere all balls inside are one but for roundings.
constexpr double kShort = 0.7;

Cloud ellipsoid(std::size_t count, double size = 1) {
  return from_parameters(count, [=](auto& random) {
    const Point3 d = direction(random);
    return scaled({d.x, kShort * d.y, 0.85 * d.z}, size);
  });
}

constexpr double kTube = 0.35;

Cloud torus(std::size_t count) {
  return from_parameters(count, [](auto& random) {
    std::uniform_real_distribution<double> angle(0, 2 * kPi);
    std::uniform_real_distribution<double> share(0, 1 + kTube);
    // As dense everywhere.
    for (;;) {
      const double b = angle(random);
      const double ring = 1 + kTube * std::cos(b);
      if (share(random) > ring) continue;
      const double a = angle(random);
      return Point3{ring * std::cos(a), ring * std::sin(a), kTube * std::sin(b)};
    }
  });
}

/// A ball with bumps: its radius in a direction, which is an odd function but for the constant.
double bumpy_radius(const Point3& d) {
  return 1 + 0.2 * std::sin(3 * d.x) * std::cos(2 * d.y);
}

Cloud bumpy(std::size_t count) {
  return from_parameters(count, [](auto& random) {
    const Point3 d = direction(random);
    return scaled(d, bumpy_radius(d));
  });
}

/// By the rule of the midpoint.
double bumpy_volume() {
  constexpr int kSteps = 300;
  double volume = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double z = -1 + (2 * i + 1.0) / kSteps;
    for (int k = 0; k < kSteps; ++k) {
      const double a = 2 * kPi * (k + 0.5) / kSteps;
      const double across = std::sqrt(1 - z * z);
      volume += std::pow(bumpy_radius({across * std::cos(a), across * std::sin(a), z}), 3);
    }
  }
  return volume * 4 * kPi / 3 / (kSteps * kSteps);
}

Cloud both(Cloud a, const Cloud& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// Boundary voxels of an ellipsoid.
Cloud voxel_shell(double radius) {
  const auto contains = [radius](int x, int y, int z) {
    return x * x + 1.5 * y * y + 2 * z * z < radius * radius;
  };
  Cloud cloud;
  const int n = static_cast<int>(radius) + 1;
  for (int z = -n; z <= n; ++z) {
    for (int y = -n; y <= n; ++y) {
      for (int x = -n; x <= n; ++x) {
        const bool is_inner = contains(x + 1, y, z) && contains(x - 1, y, z) &&
                              contains(x, y + 1, z) && contains(x, y - 1, z) &&
                              contains(x, y, z + 1) && contains(x, y, z - 1);
        if (contains(x, y, z) && !is_inner) cloud.push_back({1.0 * x, 1.0 * y, 1.0 * z});
      }
    }
  }
  return cloud;
}

/// The vertices and triangles of a chunked surface.
struct Mesh : MeshVisitor {
  explicit Mesh(const std::string& path) { open_mesh_source({.path = path})->read(*this); }

  void vertex(std::uint64_t number, const Point3& point) override {
    const auto [at, is_new] = points.try_emplace(number, point);
    EXPECT_TRUE(is_new || at->second == point) << "two places of vertex " << number;
  }
  void triangle(const MeshTriangle& corners, const std::array<Point3, 3>& places) override {
    triangles.push_back(corners);
    six_volumes += dot(places[0], cross(places[1], places[2]));
  }

  /// Every edge is run along as often in one direction as in the other.
  void expect_closed() const {
    std::map<std::pair<std::uint64_t, std::uint64_t>, int> balance;
    std::set<std::uint64_t> used;
    for (const MeshTriangle& t : triangles) {
      EXPECT_TRUE(t[0] != t[1] && t[1] != t[2] && t[2] != t[0]);
      for (int i = 0; i < 3; ++i) {
        const std::uint64_t a = t[i];
        const std::uint64_t b = t[(i + 1) % 3];
        balance[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
        used.insert(a);
      }
    }
    EXPECT_TRUE(
        std::all_of(balance.begin(), balance.end(), [](const auto& e) { return e.second == 0; }));
    EXPECT_EQ(used.size(), points.size());
  }

  std::map<std::uint64_t, Point3> points;
  std::vector<MeshTriangle> triangles;
  double six_volumes = 0;
};

struct Shape {
  std::string name;
  std::function<Cloud()> make;
  std::int64_t euler;
  double volume;
  double tolerance;  ///< of the volume, relative
  std::uint64_t components = 1;
  std::uint64_t cavities = 0;
};

void PrintTo(const Shape& shape, std::ostream* out) {
  *out << shape.name;
}

class CrustOf : public testing::TestWithParam<Shape> {};

TEST_P(CrustOf, IsClosedHasTheTopologyAndVolumeAndGoesThroughTheSamples) {
  const Shape& shape = GetParam();
  const TestFolder folder;
  const Cloud cloud = shape.make();
  const Report report = reconstruct(options_for(folder, cloud));
  const auto& surface = report.surface;
  EXPECT_EQ(surface.boundary_edges, 0U);
  EXPECT_EQ(surface.euler, shape.euler);
  EXPECT_EQ(surface.components, shape.components);
  EXPECT_EQ(surface.cavities, shape.cavities);
  ASSERT_TRUE(surface.volume.has_value());
  EXPECT_NEAR(*surface.volume, shape.volume, shape.tolerance * shape.volume);
  ASSERT_TRUE(report.power.has_value());
  EXPECT_EQ(report.power->unbounded_faces, 0U);
  EXPECT_EQ(report.power->poles, report.poles->inner);

  const Mesh mesh(folder / "out.pvtp");
  mesh.expect_closed();
  EXPECT_EQ(mesh.points.size(), surface.vertices);
  EXPECT_EQ(mesh.triangles.size(), surface.triangles);
  EXPECT_NEAR(mesh.six_volumes / 6, *surface.volume, 1e-9 * shape.volume);
  std::uint64_t samples = 0;
  std::uint64_t next = cloud.size() + 8;  // beyond the far points
  for (const auto& [number, point] : mesh.points) {
    if (number < cloud.size()) {
      EXPECT_EQ(point, cloud[number]) << "sample " << number;
      ++samples;
    } else {
      EXPECT_EQ(number, next++);
    }
  }
  EXPECT_EQ(samples, surface.samples_on_surface);
  EXPECT_EQ(samples + surface.unused_samples, cloud.size());
  EXPECT_GT(samples, cloud.size() * 8 / 10);
}

constexpr double kBall = 4 * kPi / 3;
constexpr double kEllipsoid = kBall * kShort * 0.85;
constexpr std::size_t kPoints = kIsSlow ? 600 : 3000;
constexpr double kLoose = kIsSlow ? 4 : 1;

INSTANTIATE_TEST_SUITE_P(
    Shapes, CrustOf,
    testing::Values(
        Shape{"ellipsoid", [] { return ellipsoid(kPoints); }, 2, kEllipsoid, 0.01 * kLoose},
        Shape{"bumpy_ball", [] { return bumpy(kPoints); }, 2, bumpy_volume(), 0.01 * kLoose},
        Shape{"torus", [] { return torus(kPoints); }, 0, 2 * kPi* kPi* kTube* kTube, 0.02 * kLoose},
        Shape{"nested", [] { return both(ellipsoid(kPoints), ellipsoid(kPoints / 4, 0.4)); }, 4,
              kEllipsoid*(1 - 0.4 * 0.4 * 0.4), 0.02 * kLoose, 1, 1},
        Shape{"two_apart",
              [] {
                Cloud moved = ellipsoid(kPoints / 2);
                for (Point3& p : moved) p.x += 5;
                return both(ellipsoid(kPoints / 2), moved);
              },
              4, 2 * kEllipsoid, 0.02 * kLoose, 2}),
    [](const auto& test) { return test.param.name; });

TEST(CrustOfVoxels, IsClosedHoweverManyBallsAreTied) {
  const TestFolder folder;
  const double radius = kIsSlow ? 8 : 18;
  const Cloud cloud = voxel_shell(radius);
  const Report report = reconstruct(options_for(folder, cloud));
  EXPECT_EQ(report.surface.boundary_edges, 0U);
  const Mesh mesh(folder / "out.pvtp");
  mesh.expect_closed();
  const double truth = kBall * radius * radius * radius / std::sqrt(3);
  EXPECT_NEAR(mesh.six_volumes / 6, truth, 0.2 * truth);
  for (const auto& [number, point] : mesh.points) {
    if (number < cloud.size()) {
      EXPECT_EQ(point, cloud[number]);
    }
  }
}

class CrustRuns : public testing::TestWithParam<Shape> {};

TEST_P(CrustRuns, AreTheSameBytesForAnyWindowsThreadsAndMemory) {
  const TestFolder folder;
  RunOptions options = options_for_all(folder, GetParam().make());
  const Report first = reconstruct(options);
  const std::string expected = output_bytes(folder);
  struct How {
    std::uint64_t window_points;
    unsigned threads;
    std::uint64_t memory = std::uint64_t{512} << 20;
  };
  std::vector<How> ways{{500, 3}};
  if (!kIsSlow) ways.insert(ways.end(), {{48, 3}, {500, 1}, {0, 3}, {0, 1, kLeastMemory}});
  for (const How& how : ways) {
    SCOPED_TRACE(std::to_string(how.window_points) + " points, threads " +
                 std::to_string(how.threads));
    options.window_points = how.window_points;
    options.threads = how.threads;
    options.memory_bytes = how.memory;
    const Report report = reconstruct(options);
    EXPECT_EQ(report.surface.digest, first.surface.digest);
    EXPECT_EQ(report.delaunay.digest, first.delaunay.digest);
    EXPECT_EQ(report.surface.volume, first.surface.volume);
    EXPECT_EQ(report.power->poles, first.power->poles);
    EXPECT_EQ(report.shape->tetrahedra, first.shape->tetrahedra);
    EXPECT_EQ(output_bytes(folder) == expected, true);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Clouds, CrustRuns,
    testing::Values(Shape{"bumpy_ball", [] { return bumpy(kIsSlow ? 800 : 2000); }, 2, 0, 0},
                    Shape{"voxel_shell", [] { return voxel_shell(kIsSlow ? 6 : 12); }, 0, 0, 0},
                    Shape{"noise",
                          [] {
                            return from_parameters(kIsSlow ? 400 : 1000, [](auto& r) {
                              return families::random_point(r);
                            });
                          },
                          0, 0, 0}),
    [](const auto& test) { return test.param.name; });

TEST(CrustOfNoise, LeavesTheSameSmallBallsOutInAnyWindows) {
  const TestFolder folder;
  std::mt19937_64 random(53);
  std::normal_distribution<double> off(1, 0.03);
  Cloud cloud = bumpy(kIsSlow ? 500 : 2000);
  for (Point3& p : cloud) p = scaled(p, off(random));
  RunOptions options = options_for_all(folder, cloud);
  options.least_ball = 0.8;
  const Report first = reconstruct(options);
  EXPECT_GT(first.poles->small, cloud.size() / 10);
  EXPECT_GT(first.surface.triangles, cloud.size());
  EXPECT_EQ(first.surface.boundary_edges, 0U);
  const std::string expected = output_bytes(folder);
  options.window_points = 160;
  options.threads = 3;
  const Report second = reconstruct(options);
  EXPECT_EQ(second.poles->small, first.poles->small);
  EXPECT_TRUE(output_bytes(folder) == expected);
}

TEST(CrustRun, GoesOnAfterAFullDiskToTheSameBytes) {
  const TestFolder folder;
  RunOptions options = options_for_all(folder, bumpy(300));
  options.window_points = 160;
  const int failures = expect_same_after_full_disks(options, folder, kIsSlow ? 60 : 31,
                                                    [&] { return output_bytes(folder); });
  EXPECT_GT(failures, 1);
}

/// What a cloud that bounds nothing gives.
std::string refusal_of(const Cloud& cloud) {
  const TestFolder folder;
  const RunOptions options = options_for(folder, cloud);
  try {
    const Report report = reconstruct(options);
    return "done: " + std::to_string(report.surface.triangles) + " triangles";
  } catch (const InputError& error) {
    EXPECT_EQ(folder.names(), std::vector<std::string>{"cloud.f64"});
    return error.what();
  }
}

TEST(CrustOfTooLittle, IsRefusedInTheWordsOfOtherSurfaces) {
  EXPECT_THAT(refusal_of({}), HasSubstr("0 distinct points"));
  EXPECT_THAT(refusal_of({{1, 2, 3}}), HasSubstr("1 distinct points"));
  EXPECT_THAT(refusal_of({{1, 2, 3}, {1, 2, 3}}), HasSubstr("1 distinct points"));
  EXPECT_THAT(refusal_of({{1, 2, 3}, {2, 2, 3}, {1, 3, 4}}), HasSubstr("3 distinct points"));
  Cloud line;
  Cloud plane;
  for (int i = 0; i < 100; ++i) {
    line.push_back({1.0 * i, 2.0 * i, 0});
    plane.push_back({1.0 * (i % 10), 1.0 * (i / 10), 0.5});
  }
  EXPECT_THAT(refusal_of(line), HasSubstr("on one line"));
  EXPECT_THAT(refusal_of(plane), HasSubstr("in one plane"));
}

TEST(CrustOfTooLittle, OfATetrahedronIsEmptyForItHasNoBallInside) {
  EXPECT_EQ(refusal_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}), "done: 0 triangles");
}

TEST(CrustOfExtremes, IsRefusedWhereBallsHaveNoArithmetic) {
  for (const double scale : {1e-170, 1e-60, 1e60, 1e200, 8e307}) {
    Cloud cloud = bumpy(100);
    for (Point3& p : cloud) p = scaled(p, scale);
    EXPECT_THAT(refusal_of(cloud), HasSubstr("scale the input")) << scale;
  }
}

TEST(CrustOfExtremes, OfAnyUsualSizeIsThatOfSizeOne) {
  const TestFolder folder;
  const Cloud cloud = bumpy(400);
  const Report first = reconstruct(options_for(folder, cloud));
  for (const double scale : {0x1p-100, 0x1p100}) {
    Cloud other = cloud;
    for (Point3& p : other) p = scaled(p, scale);
    const Report report = reconstruct(options_for(folder, other));
    EXPECT_EQ(report.surface.triangles, first.surface.triangles);
    EXPECT_EQ(report.surface.euler, 2);
    EXPECT_NEAR(*report.surface.volume / scale / scale / scale, *first.surface.volume, 1e-9);
  }
}

}  // namespace
}  // namespace stream_recon
