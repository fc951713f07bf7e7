// Windows: the Delaunay structure of the whole cloud however it is cut, and what happens when a
// star does not fit.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <ostream>
#include <random>
#include <string>
#include <vector>

#include "engine/reconstruct.h"
#include "spatial/delaunay.h"
#include "spatial/simplex_digest.h"
#include "tests/io_test_folder.h"
#include "tests/point_families.h"

namespace stream_recon {
namespace {

constexpr std::uint64_t kSeed = 31;

// Points a window owns; 0: all.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr std::array<std::uint64_t, 1> kWindowPoints{500};  // each takes ten times as long
#else
constexpr std::array<std::uint64_t, 4> kWindowPoints{0, 48, 500, 1600};
#endif

using Cloud = std::vector<Point3>;

std::string write_cloud(const TestFolder& folder, const Cloud& cloud) {
  std::string bytes(reinterpret_cast<const char*>(cloud.data()), cloud.size() * sizeof(Point3));
  put_bytes(folder / "cloud.f64", bytes);
  return folder / "cloud.f64";
}

/// One window in core, without index or search.
std::string digest_in_core(const Cloud& cloud) {
  Delaunay delaunay;
  EXPECT_EQ(delaunay.insert(cloud), Delaunay::Outcome::kDone);
  SimplexDigest digest;
  for (CellId c = 0; c < delaunay.cell_slots(); ++c) {
    if (!delaunay.is_live(c) || delaunay.is_infinite(c)) continue;
    const auto v = delaunay.vertices(c);
    digest.add<4>({v[0], v[1], v[2], v[3]});
  }
  return digest.hex();
}

RunOptions options_for(const TestFolder& folder, const std::string& input) {
  RunOptions options;
  options.inputs = {input};
  options.input_format = InputFormat::kF64;
  options.surface = SurfaceKind::kGamma;
  options.output = folder / "out.ply";
  options.memory_bytes = std::uint64_t{512} << 20;
  options.threads = 1;
  return options;
}

Cloud from_parameters(int count, const std::function<Point3(int, std::mt19937_64&)>& point) {
  std::mt19937_64 random(kSeed);
  Cloud cloud;
  for (int i = 0; i < count; ++i) cloud.push_back(point(i, random));
  return cloud;
}

Point3 on_sphere(std::mt19937_64& random) {
  const Point3 p = families::random_point(random);
  const double length = std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z);
  return {p.x / length, p.y / length, p.z / length};
}

struct NamedCloud {
  std::string name;
  std::function<Cloud()> make;
};

void PrintTo(const NamedCloud& cloud, std::ostream* out) {
  *out << cloud.name;
}

class Windows : public testing::TestWithParam<NamedCloud> {};

TEST_P(Windows, OfAnySizeGiveTheTetrahedraOfTheWholeCloudAndTheSameSurface) {
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  const TestFolder folder;
  const Cloud cloud = GetParam().make();
  RunOptions options = options_for(folder, write_cloud(folder, cloud));
  const std::string expected = digest_in_core(cloud);
  std::string surface;
  for (const std::uint64_t points : kWindowPoints) {
    for (const unsigned threads : {1U, 3U}) {
      options.window_points = points;
      options.threads = threads;
      const Report report = reconstruct(options);
      EXPECT_EQ(report.delaunay.digest, expected) << points << " points a window";
      const std::string bytes = file_bytes(options.output);
      if (surface.empty()) surface = bytes;
      EXPECT_EQ(bytes == surface, true) << points << " points, threads " << threads;
      EXPECT_GE(report.windows.count, points == 0 ? 1 : cloud.size() / points);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Clouds, Windows,
    testing::Values(
        NamedCloud{"random",
                   [] {
                     return from_parameters(
                         3000, [](int, auto& random) { return families::random_point(random); });
                   }},
        NamedCloud{"lattice_block",
                   [] {
                     return from_parameters(13 * 14 * 15, [](int i, auto&) {
                       return Point3{0.1 * (i % 13), 0.1 * (i / 13 % 14), 0.1 * (i / 182)};
                     });
                   }},
        NamedCloud{"slices_of_a_lattice",
                   [] {
                     return from_parameters(20 * 20 * 6, [](int i, auto&) {
                       return Point3{1.0 * (i % 20), 1.0 * (i / 20 % 20), 3.0 * (i / 400)};
                     });
                   }},
        NamedCloud{"sphere",
                   [] {
                     return from_parameters(1000,
                                            [](int, auto& random) { return on_sphere(random); });
                   }},
        NamedCloud{"ellipsoid",
                   [] {
                     return from_parameters(3000, [](int, auto& random) {
                       const Point3 p = on_sphere(random);
                       return Point3{p.x, 0.7 * p.y, 0.4 * p.z};
                     });
                   }},
        NamedCloud{"sphere_and_its_centre",
                   [] {
                     Cloud cloud =
                         from_parameters(2000, [](int, auto& random) { return on_sphere(random); });
                     cloud.push_back({0, 0, 0});
                     return cloud;
                   }},
        NamedCloud{"sphere_of_floats_far_from_the_origin",
                   [] {
                     return from_parameters(1500, [](int, auto& random) {
                       const Point3 p = on_sphere(random);
                       return Point3{static_cast<float>(100 + p.x), static_cast<float>(p.y - 50),
                                     static_cast<float>(p.z)};
                     });
                   }},
        NamedCloud{"skew_lines",
                   [] {
                     return from_parameters(240, [](int i, auto&) {
                       return i % 2 == 0 ? Point3{1.0 * i, 0, 0} : Point3{0.5, 1.0 * i, 1};
                     });
                   }},
        NamedCloud{"helix",
                   [] {
                     return from_parameters(400, [](int i, auto&) {
                       const double angle = 0.05 * i;
                       return Point3{std::cos(angle), std::sin(angle), 0.1 * angle};
                     });
                   }},
        NamedCloud{"tilted_plane_with_rounding_and_one_point_off_it",
                   [] {
                     Cloud cloud = from_parameters(1500, [](int, auto& random) {
                       const Point3 p = families::random_point(random);
                       return Point3{p.x, p.y, 0.3 * p.x + 0.7 * p.y};
                     });
                     cloud.push_back({0, 0, 5});
                     return cloud;
                   }},
        NamedCloud{"exact_plane_and_one_point_off_it",
                   [] {
                     Cloud cloud = from_parameters(40 * 40, [](int i, auto&) {
                       return Point3{1.0 * (i % 40), 1.0 * (i / 40), 0};
                     });
                     cloud.push_back({17.25, 3.5, 1});
                     return cloud;
                   }},
        NamedCloud{"detail_of_a_millionth_at_a_million",
                   [] {
                     return from_parameters(2000, [](int, auto& random) {
                       const Point3 p = families::random_point(random);
                       return Point3{1e6 + 1e-5 * p.x, 1e6 + 1e-5 * p.y, 1e6 + 1e-5 * p.z};
                     });
                   }},
        NamedCloud{"clusters_a_trillion_apart",
                   [] {
                     return from_parameters(2000, [](int i, auto& random) {
                       const Point3 p = families::random_point(random);
                       const double at = i % 2 == 0 ? 1e12 : 0;
                       return Point3{at + p.x, p.y, p.z};
                     });
                   }},
        NamedCloud{"tiny",
                   [] {
                     return from_parameters(1500, [](int, auto& random) {
                       const Point3 p = families::random_point(random);
                       return Point3{1e-170 * p.x, 1e-170 * p.y, 1e-170 * p.z};
                     });
                   }},
        NamedCloud{"huge",
                   [] {
                     return from_parameters(1500, [](int, auto& random) {
                       const Point3 p = families::random_point(random);
                       return Point3{1e120 * p.x, 1e120 * p.y, 1e120 * p.z};
                     });
                   }}),
    [](const auto& test) { return test.param.name; });

/// Two unit spheres, a multiple of `apart` from each other; one where it is 0.
Cloud on_spheres(double apart) {
  return from_parameters(20000, [apart](int i, auto& random) {
    const Point3 p = on_sphere(random);
    return Point3{p.x + i % 2 * apart, p.y, p.z};
  });
}

TEST(WindowWork, OfPointsOnASphereIsAsOfAnyOtherSurface) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "counts the same with a sanitizer";
#endif
  for (const double apart : {0.0, 5.0}) {
    for (const bool rounds : {false, true}) {
      SCOPED_TRACE(testing::Message() << "apart " << apart << ", floats " << rounds);
      const TestFolder folder;
      Cloud cloud = on_spheres(apart);
      for (Point3& p : cloud) {
        if (rounds) p = {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
      }
      RunOptions options = options_for(folder, write_cloud(folder, cloud));
      options.window_points = 5000;
      const Report report = reconstruct(options);
      EXPECT_EQ(report.delaunay.digest, digest_in_core(cloud));
      const auto queries = static_cast<double>(report.windows.queries);
      // Hundreds, and thousands, where every ball meets every point; one page has both spheres.
      const double exact_tests = apart == 0 ? 2 : 80;
      EXPECT_LT(static_cast<double>(report.windows.node_visits), (apart == 0 ? 30 : 60) * queries);
      EXPECT_LT(static_cast<double>(report.windows.exact_tests), exact_tests * queries);
    }
  }
}

/// A wavy sheet cut by a box, as a scanned volume is: thousands of samples in its flat sides.
Cloud cut_by_a_box(int count) {
  return from_parameters(count, [](int i, auto& random) {
    Point3 p = families::random_point(random);
    const double wave = 0.4 * std::sin(4 * p.x) * std::cos(3 * p.y);
    if (i % 3 == 0) return Point3{p.x, p.y, -1};
    if (i % 3 == 1) return Point3{1, p.y, -1 + (1 + p.z) / 4};
    return Point3{p.x, p.y, wave};
  });
}

TEST(WindowWork, OfFlatSidesSquareToTheAxesIsAsOfAnyOtherSurface) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "counts the same with a sanitizer";
#endif
  const TestFolder folder;
  const Cloud cloud = cut_by_a_box(12000);
  RunOptions options = options_for(folder, write_cloud(folder, cloud));
  options.window_points = 3000;
  const Report report = reconstruct(options);
  EXPECT_EQ(report.delaunay.digest, digest_in_core(cloud));
  EXPECT_LT(static_cast<double>(report.windows.node_visits),
            60 * static_cast<double>(report.windows.queries));
  // Hundreds where every facet of a side meets every point of it.
  EXPECT_LT(static_cast<double>(report.windows.exact_tests),
            4 * static_cast<double>(report.windows.queries));
}

TEST(WindowLimits, AStarThatDoesNotFitIsRefusedWithTheNumbers) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "takes minutes with a sanitizer; the other builds run it";
#endif
  const TestFolder folder;
  // The hub comes first on the curve, so that all of its star is asked for.
  Cloud cloud = from_parameters(300000, [](int, auto& random) {
    const Point3 p = on_sphere(random);
    return Point3{std::abs(p.x), std::abs(p.y), std::abs(p.z)};
  });
  cloud.push_back({0, 0, 0});
  RunOptions options = options_for(folder, write_cloud(folder, cloud));
  options.surface = SurfaceKind::kNone;
  options.memory_bytes = kLeastMemory;
  try {
    reconstruct(options);
    FAIL() << "a star of 300 thousand points fitted " << kLeastMemory << " bytes";
  } catch (const BudgetError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("the tetrahedra around"));
    EXPECT_THAT(error.what(), testing::HasSubstr("give --memory"));
    EXPECT_THAT(error.what(), testing::HasSubstr("add --resume"));
  }
}

TEST(WindowLimits, ACloudLargerThanTheMemoryIsDoneInWindows) {
  const TestFolder folder;
  const Cloud cloud =
      from_parameters(150000, [](int, auto& random) { return families::random_point(random); });
  RunOptions options = options_for(folder, write_cloud(folder, cloud));
  options.surface = SurfaceKind::kNone;
  options.memory_bytes = kLeastMemory;
  const Report report = reconstruct(options);
  EXPECT_GT(report.windows.count, 3);
  EXPECT_EQ(report.delaunay.digest, digest_in_core(cloud));
}

}  // namespace
}  // namespace stream_recon
