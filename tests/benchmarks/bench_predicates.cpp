// What the predicates cost on random points, on a lattice (where most questions are ties) and on
// points where only the exact rungs help. A lattice may cost three times as much as random points.
#include <benchmark/benchmark.h>

#include <array>
#include <random>
#include <vector>

#include "spatial/predicates.h"
#include "tests/point_families.h"

namespace stream_recon {
namespace {

constexpr std::size_t kQuestions = 4096;

struct Questions {
  std::vector<std::array<Point3, 5>> points;
  Predicates predicates;
};

// Positively oriented tetrahedra with a query, all five distinct.
Questions make_questions(Point3 (*draw)(std::mt19937_64&)) {
  std::mt19937_64 random(1);
  std::vector<std::array<Point3, 5>> drawn;
  CoordinateRange range;
  range.extend(1);
  while (drawn.size() < kQuestions) {
    std::array<Point3, 5> p;
    for (Point3& q : p) {
      q = draw(random);
      range.extend(q);
    }
    const int sign = Predicates(range).orient3d(p[0], p[1], p[2], p[3]);
    if (sign < 0) std::swap(p[0], p[1]);
    if (sign != 0 && std::find(p.begin(), p.end() - 1, p[4]) == p.end() - 1) drawn.push_back(p);
  }
  return {std::move(drawn), Predicates(range)};
}

Point3 cube_corner(std::mt19937_64& random) {
  const auto bits = random();
  return {double(bits & 1), double(bits >> 1 & 1), double(bits >> 2 & 1)};
}
Point3 near_lattice(std::mt19937_64& random) {
  return families::lattice_point(random, 3, 1);
}
Point3 uneven_lattice(std::mt19937_64& random) {
  return families::lattice_point(random, 1, 0.7);
}

template <Point3 (*kDraw)(std::mt19937_64&)>
void in_sphere(benchmark::State& state) {
  const Questions questions = make_questions(kDraw);
  std::size_t i = 0;
  for (auto _ : state) {
    const auto& p = questions.points[i++ % kQuestions];
    benchmark::DoNotOptimize(
        questions.predicates.in_sphere_perturbed(p[0], p[1], p[2], p[3], p[4]));
  }
}

template <Point3 (*kDraw)(std::mt19937_64&)>
void orient3d(benchmark::State& state) {
  const Questions questions = make_questions(kDraw);
  std::size_t i = 0;
  for (auto _ : state) {
    const auto& p = questions.points[i++ % kQuestions];
    benchmark::DoNotOptimize(questions.predicates.orient3d(p[0], p[1], p[2], p[4]));
  }
}

BENCHMARK(in_sphere<families::random_point>)->Name("in_sphere/random");
BENCHMARK(in_sphere<near_lattice>)->Name("in_sphere/lattice");
BENCHMARK(in_sphere<cube_corner>)->Name("in_sphere/all_cospherical");
BENCHMARK(in_sphere<uneven_lattice>)->Name("in_sphere/spacing_0.7");
BENCHMARK(orient3d<families::random_point>)->Name("orient3d/random");
BENCHMARK(orient3d<near_lattice>)->Name("orient3d/lattice");
BENCHMARK(orient3d<cube_corner>)->Name("orient3d/cube_corners");
BENCHMARK(orient3d<uneven_lattice>)->Name("orient3d/spacing_0.7");

}  // namespace
}  // namespace stream_recon
