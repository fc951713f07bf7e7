// The power shape: what the windows of the power diagram emit of it is the subcomplex of inner
// poles of the whole regular triangulation.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <ostream>
#include <random>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "engine/shape/shape_chunks.h"
#include "engine/shape/shape_faces.h"
#include "engine/shape/shape_store.h"
#include "engine/windows/certified_window.h"
#include "engine/windows/index_reader.h"
#include "tests/point_families.h"
#include "tests/pole_clouds.h"

namespace stream_recon {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr std::size_t kShare = 5;  // of the points: each takes ten times as long
#else
constexpr std::size_t kShare = 1;
#endif

constexpr std::uint64_t kMemory = std::uint64_t{2} << 30;

using Cloud = std::vector<Point3>;

Cloud torus(std::size_t count) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> angle(0, 6.283185307179586);
  Cloud cloud;
  for (std::size_t i = 0; i < count; ++i) {
    const double a = angle(random);
    const double b = angle(random);
    const double ring = 1 + 0.35 * std::cos(b);
    cloud.push_back({ring * std::cos(a), ring * std::sin(a), 0.35 * std::sin(b)});
  }
  return cloud;
}

bool is_in_torus(const Point3& p) {
  return std::hypot(std::hypot(p.x, p.y) - 1, p.z) < 0.35;
}

Cloud noise(std::size_t count) {
  std::mt19937_64 random(5);
  Cloud cloud(count);
  for (Point3& p : cloud) p = families::random_point(random);
  return cloud;
}

/// Cospherical samples everywhere.
Cloud lattice(int size) {
  Cloud cloud;
  for (int z = 0; z < size; ++z) {
    for (int y = 0; y < size; ++y) {
      for (int x = 0; x < size; ++x) cloud.push_back({1.0 * x, 1.0 * y, 1.0 * z});
    }
  }
  return cloud;
}

/// One in so many poles is inside.
PoleCloud::IsInside random_labels(std::uint64_t in) {
  auto random = std::make_shared<std::mt19937_64>(11);
  return [random, in](const Point3&) { return (*random)() % in == 0; };
}

struct Complex {
  std::set<std::array<PoleNumber, 3>> faces;  ///< triangles, and edges without one
  ShapeCounts counts;

  void add(const ShapeFaces& part) {
    for (const ShapeFace& face : part.faces) {
      EXPECT_TRUE(faces.insert(face.poles).second) << "a face is there twice";
    }
    counts.add(part.counts);
  }
};

void expect_equal(const Complex& found, const Complex& expected) {
  EXPECT_TRUE(found.faces == expected.faces)
      << found.faces.size() << " faces for " << expected.faces.size();
  EXPECT_EQ(found.counts.vertices, expected.counts.vertices);
  EXPECT_EQ(found.counts.edges, expected.counts.edges);
  EXPECT_EQ(found.counts.bare_edges, expected.counts.bare_edges);
  EXPECT_EQ(found.counts.triangles, expected.counts.triangles);
  EXPECT_EQ(found.counts.tetrahedra, expected.counts.tetrahedra);
}

/// By listing the inner poles of every cell of the triangulation of all, in core.
Complex complex_of_all(const PoleCloud& cloud, const PoleIndex& poles) {
  RegularTriangulation whole({.range = poles.range()});
  std::vector<WeightedPoint3> sites;
  for (const Pole& pole : cloud.poles) sites.push_back(site_of(pole));
  EXPECT_EQ(whole.insert(sites), RegularTriangulation::Outcome::kDone);
  std::array<std::set<std::vector<PoleNumber>>, 5> simplices;  // by their number of poles
  const WeightedCellView view = whole.view();
  for (CellId c = 0; c < view.slots(); ++c) {
    if (!view.is_live(c)) continue;
    std::vector<PoleNumber> inner;
    for (const VertexId v : view.vertices(c)) {
      if (v != RegularTriangulation::kInfinite && cloud.poles[v].is_inside != 0) inner.push_back(v);
    }
    std::sort(inner.begin(), inner.end());
    for (unsigned some = 1; some < 1U << inner.size(); ++some) {
      std::vector<PoleNumber> simplex;
      for (std::size_t i = 0; i < inner.size(); ++i) {
        if ((some >> i & 1) != 0) simplex.push_back(inner[i]);
      }
      simplices[simplex.size()].insert(simplex);
    }
  }
  Complex complex;
  std::set<std::vector<PoleNumber>> bare = simplices[2];
  for (const auto& t : simplices[3]) {
    complex.faces.insert({t[0], t[1], t[2]});
    for (const auto& [a, b] : {std::array{0, 1}, std::array{0, 2}, std::array{1, 2}}) {
      bare.erase({t[a], t[b]});
    }
  }
  for (const auto& edge : bare) complex.faces.insert({edge[0], edge[1], kNoPole});
  complex.counts = {.vertices = simplices[1].size(),
                    .edges = simplices[2].size(),
                    .bare_edges = bare.size(),
                    .triangles = simplices[3].size(),
                    .tetrahedra = simplices[4].size()};
  return complex;
}

struct Case {
  std::string name;
  std::function<Cloud()> make;
  std::function<PoleCloud::IsInside()> labels;
};

void PrintTo(const Case& of, std::ostream* out) {
  *out << of.name;
}

class Shape : public testing::TestWithParam<Case> {};

TEST_P(Shape, OfWindowsOfAnySizeIsThatOfTheWholeDiagram) {
  const PoleCloud cloud(GetParam().make(), GetParam().labels());
  const PoleIndex poles(cloud.stage.scratch, 3);
  PoleFinder finder(poles);
  IndexCaches caches(cloud.stage.scratch, cloud.index, std::uint64_t{16} << 20);
  IndexReader reader(caches);
  CertifiedWindow samples(cloud.index, reader, cloud.stage.context, {.whole_stars = true});
  const Complex whole = complex_of_all(cloud, poles);
  ASSERT_GT(whole.counts.vertices, 50U) << "there is nothing to be found";
  ASSERT_GT(whole.counts.tetrahedra, 0U);
  ASSERT_GT(whole.counts.bare_edges, 0U);
  const std::uint64_t count = cloud.points.size();
  for (const std::uint64_t size : {count, count / 3 / 16 * 16, count / 7 / 16 * 16}) {
    SCOPED_TRACE(std::to_string(size) + " samples a window");
    Complex found;
    for (std::uint64_t first = 0; first < count; first += size) {
      const OwnedRange owned{first, std::min(size, count - first)};
      ASSERT_EQ(samples.build(owned, kMemory), CertifiedWindow::Outcome::kDone);
      PowerWindow power(samples, poles, finder);
      ASSERT_EQ(power.build(owned, kMemory), CertifiedWindow::Outcome::kDone);
      const ShapeFaces part = shape_faces(power);
      EXPECT_TRUE(std::is_sorted(part.faces.begin(), part.faces.end()));
      for (const ShapeFace& face : part.faces) {
        EXPECT_GE(cloud.poles[face.poles[0]].lowest_rank(), owned.first);
        EXPECT_LT(cloud.poles[face.poles[0]].lowest_rank(), owned.end());
      }
      found.add(part);
      samples.clear();
    }
    expect_equal(found, whole);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Clouds, Shape,
    testing::Values(Case{"torus", [] { return torus(1500 / kShare); },
                         [] { return PoleCloud::IsInside(is_in_torus); }},
                    Case{"noise_with_few_inside", [] { return noise(1500 / kShare); },
                         [] { return random_labels(6); }},
                    Case{"noise_with_half_inside", [] { return noise(800 / kShare); },
                         [] { return random_labels(2); }},
                    Case{"lattice_with_few_inside", [] { return lattice(kShare == 1 ? 9 : 6); },
                         [] { return random_labels(3); }}),
    [](const auto& test) { return test.param.name; });

/// Faces of poles 0 .. 99, written in two windows whose order is not that of their samples.
std::vector<ShapeFace> store_faces(const StageFixture& stage) {
  std::vector<ShapeFace> faces;
  for (PoleNumber a = 0; a < 90; ++a) {
    if (a % 10 == 3) continue;
    faces.push_back({{a, a + 1, a + 9}});
    if (a % 4 == 0) faces.push_back({{a, a + 10, kNoPole}});
  }
  const auto first = static_cast<std::size_t>(std::count_if(
      faces.begin(), faces.end(), [](const ShapeFace& face) { return face.poles[0] < 40; }));
  write_shape_window(stage.context.scratch, 700, std::span(faces).subspan(first));
  write_shape_window(stage.context.scratch, 0, std::span(faces).first(first));
  store_shape({700, 0}, stage.context);
  return faces;
}

TEST(ShapeStore, IsInTheOrderOfPolesAndCutIntoChunks) {
  const StageFixture stage;
  const std::vector<ShapeFace> faces = store_faces(stage);
  EXPECT_EQ(stage.context.scratch.names(), std::vector<std::string>{kShapeStore});
  // Without poles, with one, without faces (poles 93 to 95), and behind all faces.
  const std::vector<std::uint64_t> ends{0, 1, 1, 30, 93, 96, 100};
  const ShapeChunks chunks(ends, stage.context);
  std::vector<ShapeFace> all;
  for (std::size_t chunk = 0; chunk < ends.size(); ++chunk) {
    const std::size_t before = all.size();
    std::uint64_t edges = 0;
    std::uint64_t later = 0;
    chunks.visit(chunk, [&](const ShapeFace& face) {
      EXPECT_LT(face.poles[0], ends[chunk]);
      EXPECT_GE(face.poles[0], chunk == 0 ? 0 : ends[chunk - 1]);
      edges += face.is_edge() ? 1 : 0;
      for (const PoleNumber pole : face.poles) later += pole != kNoPole && pole >= ends[chunk];
      all.push_back(face);
    });
    EXPECT_EQ(chunks.count(chunk), all.size() - before);
    EXPECT_EQ(chunks.edges(chunk), edges);
    EXPECT_EQ(chunks.later_corners(chunk), later);
  }
  ASSERT_EQ(all.size(), faces.size());
  for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(all[i].poles, faces[i].poles);
}

}  // namespace
}  // namespace stream_recon
