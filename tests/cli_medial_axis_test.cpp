// The medial axis as another program finds it: balls that touch the samples, of the side asked
// for, whatever the resources of the run.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <functional>
#include <optional>
#include <ostream>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "spatial/point.h"
#include "tests/cli_program.h"

namespace stream_recon {
namespace {

struct Ball {
  Point3 centre;
  double radius;
  double angle;
  int label;
};

struct Axis {
  std::vector<Ball> balls;
  nlohmann::json facts;
};

/// As VTK reads it; nothing where VTK is missing.
std::optional<nlohmann::json> facts_of(const CommandFolder& folder, const std::string& index) {
  const Outcome read =
      folder.run(STREAM_RECON_VTK_PYTHON " " STREAM_RECON_TESTS "/cli_medial_axis_check.py " +
                 index + " cloud.f64");
  // 77 is the script's word for a missing VTK, 127 the shell's for a missing Python.
  if (read.exit_code == 77 || read.exit_code == 127) return std::nullopt;
  EXPECT_EQ(read.exit_code, 0) << read.out << read.error;
  return nlohmann::json::parse(read.out);
}

/// Without faces.
std::optional<Axis> axis_of(const CommandFolder& folder, const std::string& index) {
  const auto facts = facts_of(folder, index);
  if (!facts) return std::nullopt;
  Axis axis{{}, *facts};
  axis.balls.reserve(axis.facts["balls"].size());
  for (const auto& b : axis.facts["balls"]) {
    axis.balls.push_back({{b[0], b[1], b[2]}, b[3], b[4], b[5]});
  }
  EXPECT_EQ(axis.facts["shape"], nullptr);
  EXPECT_EQ(axis.facts["vertices"], axis.balls.size());
  EXPECT_EQ(axis.facts["cells_by_index"], axis.balls.size());
  EXPECT_LT(axis.facts["off_sample"].get<double>(), 1e-9) << "a ball does not touch its sample";
  for (const Ball& ball : axis.balls) {
    EXPECT_GT(ball.angle, 0);
    EXPECT_LE(ball.angle, 180);
  }
  return axis;
}

void put_cloud(const CommandFolder& folder, const std::vector<Point3>& points) {
  std::ofstream out(folder.path("cloud.f64"), std::ios::binary);
  for (const Point3& p : points) out.write(reinterpret_cast<const char*>(&p), sizeof p);
}

nlohmann::json report_of(const CommandFolder& folder, const std::string& arguments) {
  const Outcome outcome =
      folder.run("stream-recon cloud.f64 --report r.json --progress none " + arguments);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
  return folder.json("r.json");
}

std::vector<Point3> surface_points(int count, const std::function<Point3(double, double)>& at) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> one(0, 1);
  std::vector<Point3> points;
  for (int i = 0; i < count; ++i) points.push_back(at(one(random), one(random)));
  return points;
}

/// A torus of tube 1.
std::vector<Point3> torus_points(int count) {
  return surface_points(count, [](double u, double v) {
    const double r = 3 + std::cos(6.2831853 * u);
    return Point3{r * std::cos(6.2831853 * v), r * std::sin(6.2831853 * v),
                  std::sin(6.2831853 * u)};
  });
}

TEST(MedialAxis, OfASphereIsItsMiddle) {
  const CommandFolder folder;
  put_cloud(
      folder, surface_points(3000, [](double u, double v) {
        const double z = 2 * u - 1;
        const double r = std::sqrt(1 - z * z);
        return Point3{5 + 2 * r * std::cos(6.2831853 * v), 2 * r * std::sin(6.2831853 * v), 2 * z};
      }));
  const auto report = report_of(folder, "-o s.pvtp --medial-axis m.pvtp");
  EXPECT_EQ(report["surface"]["euler"], 2);
  EXPECT_GT(report["poles"]["inner"], 0);
  EXPECT_EQ(report["poles"]["count"],
            report["poles"]["inner"].get<int>() + report["poles"]["outer"].get<int>());
  const auto axis = axis_of(folder, "m.pvtp");
  if (!axis) GTEST_SKIP() << "install python3-vtk9";
  EXPECT_EQ(axis->balls.size(), report["poles"]["inner"]);
  for (const Ball& ball : axis->balls) {
    EXPECT_EQ(ball.label, 1);
    EXPECT_LT(std::hypot(ball.centre.x - 5, ball.centre.y, ball.centre.z), 1e-5);
    EXPECT_NEAR(ball.radius, 2, 1e-5);
  }
}

TEST(MedialAxis, OfATorusIsItsCoreCircle) {
  const CommandFolder folder;
  put_cloud(folder, torus_points(12000));
  const auto report = report_of(folder, "--surface none --medial-axis m.pvtp --chunk-points 5000");
  EXPECT_EQ(report["surface"]["kind"], "none");
  const auto axis = axis_of(folder, "m.pvtp");
  if (!axis) GTEST_SKIP() << "install python3-vtk9";
  EXPECT_EQ(axis->facts["chunks"], 3);
  ASSERT_GT(axis->balls.size(), 1000U);
  for (const Ball& ball : axis->balls) {
    const double off = std::hypot(std::hypot(ball.centre.x, ball.centre.y) - 3, ball.centre.z);
    EXPECT_LT(off, 0.1);
    EXPECT_NEAR(ball.radius, 1, 0.1);
  }
  const auto wide = std::count_if(axis->balls.begin(), axis->balls.end(),
                                  [](const Ball& ball) { return ball.angle > 120; });
  EXPECT_GT(static_cast<std::size_t>(wide), axis->balls.size() / 2);
}

TEST(MedialAxis, HasTheSideAskedForAndTheSurfaceIsAsWithoutIt) {
  const CommandFolder folder;
  ASSERT_EQ(folder.run("make-cloud folded -n 6000 -o cloud.f64").exit_code, 0);
  report_of(folder, "--chunk-points 1500 -o plain.pvtp");
  const std::string run = "--chunk-points 1500 -o s.pvtp --medial-axis m.pvtp --medial-axis-side ";
  std::array<std::uint64_t, 3> counts{};
  std::size_t i = 0;
  for (const std::string side : {"inner", "outer", "both"}) {
    const auto report = report_of(folder, run + side);
    EXPECT_TRUE(folder.chunked_bytes("s", ".pvtp") == folder.chunked_bytes("plain", ".pvtp"));
    const auto axis = axis_of(folder, "m.pvtp");
    if (!axis) GTEST_SKIP() << "install python3-vtk9";
    counts[i++] = axis->balls.size();
    const auto inside = static_cast<std::uint64_t>(std::count_if(
        axis->balls.begin(), axis->balls.end(), [](const Ball& ball) { return ball.label == 1; }));
    EXPECT_EQ(inside, side == "outer" ? 0 : report["poles"]["inner"].get<std::uint64_t>());
  }
  EXPECT_GT(counts[0], 1000U);
  EXPECT_GT(counts[1], 1000U);
  EXPECT_EQ(counts[2], counts[0] + counts[1]);
}

TEST(MedialAxis, IsTheSameForAnyMemoryThreadsAndSurface) {
  const CommandFolder folder;
  ASSERT_EQ(folder
                .run("make-cloud folded -n 40000 --sampling centres --slice-step 2 "
                     "-o cloud.f64")
                .exit_code,
            0);
  const std::string run = "--chunk-points 9000 --medial-axis-side both ";
  const auto first = report_of(folder, run + "-o s.pvtp --medial-axis first.pvtp --memory 1G");
  EXPECT_GT(first["poles"]["coincident"], 0);
  for (const std::string options :
       {"--surface none --memory 64M --threads 1", "--surface none --memory 300M --threads 3",
        "-o s.ply --memory 80M --threads 2"}) {
    const auto report = report_of(folder, run + options + " --medial-axis next.pvtp");
    EXPECT_EQ(report["poles"], first["poles"]) << options;
    EXPECT_TRUE(folder.chunked_bytes("next", ".pvtp") == folder.chunked_bytes("first", ".pvtp"))
        << options;
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    EXPECT_LE(report["peak_rss_bytes"], report["memory_budget_bytes"]) << options;
#endif
  }
}

TEST(MedialAxis, OfOneTetrahedronIsItsBallOrOneChunkWithoutBalls) {
  const CommandFolder folder;
  put_cloud(folder, {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}});
  const auto report =
      report_of(folder, "--surface none --medial-axis m.pvtp --medial-axis-side both");
  EXPECT_EQ(report["poles"]["unbounded"], 4);
  const auto inner = report_of(folder, "--surface none --medial-axis i.pvtp");
  const auto axis = axis_of(folder, "m.pvtp");
  const auto inner_axis = axis_of(folder, "i.pvtp");
  if (!axis || !inner_axis) GTEST_SKIP() << "install python3-vtk9";
  EXPECT_EQ(inner_axis->facts["chunks"], 1);
  EXPECT_EQ(inner_axis->balls.size(), inner["poles"]["inner"]);
  EXPECT_EQ(axis->balls.size(), report["poles"]["count"]);
  for (const Ball& ball : axis->balls) {
    EXPECT_EQ(ball.centre, (Point3{1, 1, 1}));
    EXPECT_DOUBLE_EQ(ball.radius, std::sqrt(3));
  }
}

TEST(MedialAxis, OfARunThatFailsLeavesTheOlderOneAlone) {
  const CommandFolder folder;
  ASSERT_EQ(folder.run("make-cloud cube -n 2000 -o cloud.f64").exit_code, 0);
  report_of(folder, "-o s.pvtp --medial-axis m.pvtp");
  const std::string older = folder.chunked_bytes("m", ".pvtp");
  EXPECT_EQ(folder
                .run("touch s/mine; stream-recon cloud.f64 -o s.pvtp --medial-axis m.pvtp "
                     "--medial-axis-side both")
                .exit_code,
            74);
  EXPECT_TRUE(folder.chunked_bytes("m", ".pvtp") == older);
  EXPECT_EQ(folder.names(),
            (std::vector<std::string>{"cloud.f64", "m", "m.pvtp", "r.json", "s", "s.pvtp"}));
}

TEST(MedialAxis, IsNamedInThePageOfTheRun) {
  const CommandFolder folder;
  ASSERT_EQ(folder.run("make-cloud cube -n 2000 -o cloud.f64").exit_code, 0);
  report_of(folder, "--surface none --medial-axis m.pvtp --medial-axis-faces --html page.html");
  const std::string page = folder.bytes("page.html");
  EXPECT_NE(page.find("m.pvtp"), std::string::npos);
  EXPECT_NE(page.find("<h2>Poles</h2>"), std::string::npos);
  EXPECT_NE(page.find("<h2>Power shape</h2>"), std::string::npos);
}

TEST(PoleTolerance, OfZeroChangesNothing) {
  const CommandFolder folder;
  put_cloud(folder, torus_points(3000));
  const std::string run = "--surface none --medial-axis-side both --medial-axis ";
  const auto plain = report_of(folder, run + "plain.pvtp");
  const auto zero = report_of(folder, run + "zero.pvtp --pole-tolerance 0");
  EXPECT_EQ(zero["poles"], plain["poles"]);
  EXPECT_TRUE(folder.chunked_bytes("zero", ".pvtp") == folder.chunked_bytes("plain", ".pvtp"));
}

TEST(PoleTolerance, MakesNearBallsOneOfThemAndSaysHowMany) {
  const CommandFolder folder;
  put_cloud(folder, torus_points(3000));
  const double tolerance = 0.01;
  const std::string run = "--surface none --medial-axis-side both --medial-axis ";
  const auto plain = report_of(folder, run + "plain.pvtp")["poles"];
  const auto merged = report_of(folder, run + "merged.pvtp --pole-tolerance 0.01")["poles"];
  EXPECT_LT(merged["inner"].get<int>(), plain["inner"].get<int>() * 3 / 4);
  EXPECT_EQ(merged["count"].get<int>() + merged["coincident"].get<int>(),
            plain["count"].get<int>() + plain["coincident"].get<int>());
  const auto before = axis_of(folder, "plain.pvtp");
  const auto after = axis_of(folder, "merged.pvtp");
  if (!before || !after) GTEST_SKIP() << "install python3-vtk9";
  EXPECT_EQ(after->balls.size(), merged["count"]);
  using Key = std::array<double, 4>;
  const auto key_of = [](const Ball& ball) {
    return Key{ball.centre.x, ball.centre.y, ball.centre.z, ball.radius};
  };
  const auto rounded = [=](Key key) {
    for (double& value : key) value = std::floor(value / tolerance + 0.5);
    return key;
  };
  std::set<Key> all;
  std::set<Key> places;
  for (const Ball& ball : before->balls) {
    all.insert(key_of(ball));
    places.insert(rounded(key_of(ball)));
  }
  EXPECT_EQ(after->balls.size(), places.size());
  for (const Ball& ball : after->balls) {
    EXPECT_EQ(all.count(key_of(ball)), 1U) << "a ball was moved";
    EXPECT_EQ(places.erase(rounded(key_of(ball))), 1U) << "two balls of one place";
  }
}

TEST(PoleTolerance, OfASphereLeavesOneBallInside) {
  const CommandFolder folder;
  put_cloud(folder, surface_points(2000, [](double u, double v) {
              const double z = 2 * u - 1;
              const double r = std::sqrt(1 - z * z);
              return Point3{5 + r * std::cos(6.2831853 * v), r * std::sin(6.2831853 * v), z};
            }));
  const std::string run = "--surface none --medial-axis m.pvtp --medial-axis-faces ";
  const auto report = report_of(folder, run + "--pole-tolerance 1e-9");
  EXPECT_EQ(report["poles"]["inner"], 1);
  EXPECT_GT(report["poles"]["coincident"], 100);
  EXPECT_EQ(report["shape"]["vertices"], 1);
  EXPECT_EQ(report["shape"]["euler"], 1);
}

struct Body {
  std::string kind;
  int points;
  int euler;   ///< of its inside
  int pieces;  ///< likewise
};

void PrintTo(const Body& body, std::ostream* out) {
  *out << body.kind;
}

class PowerShape : public testing::TestWithParam<Body> {};

TEST_P(PowerShape, HasTheTopologyOfTheBodyAndFitsAcrossChunks) {
  const Body& body = GetParam();
  const CommandFolder folder;
  const std::string count = std::to_string(body.points);
  ASSERT_EQ(folder.run("make-cloud " + body.kind + " -n " + count + " -o cloud.f64").exit_code, 0);
  const auto report = report_of(
      folder, "--surface none --medial-axis m.pvtp --medial-axis-faces --chunk-points 700");
  EXPECT_GE(report["power"]["windows"], 1);
  const auto& shape = report["shape"];
  EXPECT_EQ(shape["euler"], body.euler);
  // Of a sphere's balls, which are one but for roundings, some have no cell, and so no faces.
  const int inner = report["poles"]["inner"];
  const int hidden = inner - shape["vertices"].get<int>();
  EXPECT_GE(hidden, 0);
  EXPECT_LT(hidden, inner / 50);
  ASSERT_EQ(folder.run("mesh-check m.pvtp --json >mesh.json").exit_code, 0);
  const auto mesh = folder.json("mesh.json");
  EXPECT_EQ(mesh["triangles"], shape["triangles"]);
  EXPECT_EQ(mesh["duplicate_triangles"], 0);
  EXPECT_EQ(mesh["contradictory_ids"], 0);
  const auto facts = facts_of(folder, "m.pvtp");
  if (!facts) GTEST_SKIP() << "install python3-vtk9";
  EXPECT_EQ((*facts)["vertices"], inner);
  EXPECT_LT((*facts)["off_sample"].get<double>(), 1e-9);
  const auto& read = (*facts)["shape"];
  EXPECT_GT(read["repeated"], 0);
  EXPECT_EQ(read["pieces"], body.pieces + hidden);
  EXPECT_EQ(read["balls"], inner);
  EXPECT_EQ(read["edges"], shape["edges"]);
  EXPECT_EQ(read["lines"], shape["bare_edges"]);
  EXPECT_EQ(read["triangles"], shape["triangles"]);
  EXPECT_EQ(shape["vertices"].get<int>() - read["edges"].get<int>() + read["triangles"].get<int>() -
                shape["tetrahedra"].get<int>(),
            body.euler);
}

INSTANTIATE_TEST_SUITE_P(Bodies, PowerShape,
                         testing::Values(Body{"blob", 3000, 1, 1}, Body{"uneven", 3000, 0, 1},
                                         Body{"nested", 2000, 3, 2}),
                         [](const auto& test) { return test.param.kind; });

TEST(PowerShapeRuns, AreTheSameForAnyMemoryAndThreadsAndBesideTheCrust) {
  const CommandFolder folder;
  ASSERT_EQ(folder.run("make-cloud folds -n 12000 -o cloud.f64").exit_code, 0);
  const std::string run = "--chunk-points 4000 ";
  const auto first = report_of(
      folder, run + "--surface none --medial-axis first.pvtp --medial-axis-faces --memory 1G");
  report_of(folder, run + "--surface crust -o plain.pvtp");
  for (const std::string options :
       {"--surface none --memory 64M --threads 1", "--surface none --memory 200M --threads 3",
        "--surface crust -o s.pvtp --memory 150M --threads 2"}) {
    const auto report =
        report_of(folder, run + options + " --medial-axis next.pvtp --medial-axis-faces");
    EXPECT_EQ(report["shape"], first["shape"]) << options;
    EXPECT_EQ(report["delaunay"], first["delaunay"]) << options;
    EXPECT_TRUE(folder.chunked_bytes("next", ".pvtp") == folder.chunked_bytes("first", ".pvtp"))
        << options;
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    EXPECT_LE(report["peak_rss_bytes"], report["memory_budget_bytes"]) << options;
#endif
  }
  EXPECT_TRUE(folder.chunked_bytes("s", ".pvtp") == folder.chunked_bytes("plain", ".pvtp"));
}

TEST(PowerShapeRuns, OfABodyWithoutInnerBallsAreOneChunkOfNone) {
  const CommandFolder folder;
  put_cloud(folder, {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}});
  const auto report = report_of(folder, "--surface none --medial-axis m.pvtp --medial-axis-faces");
  EXPECT_EQ(report["shape"]["vertices"], 0);
  const auto facts = facts_of(folder, "m.pvtp");
  if (!facts) GTEST_SKIP() << "install python3-vtk9";
  EXPECT_EQ((*facts)["shape"]["balls"], 0);
  EXPECT_EQ((*facts)["chunks"], 1);
}

}  // namespace
}  // namespace stream_recon
