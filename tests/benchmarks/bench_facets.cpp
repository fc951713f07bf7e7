// What a facet costs: judged on estimates, with its share of the tetrahedra's balls, and asked of
// the accurate balls. The first should be at least five times cheaper.
#include <benchmark/benchmark.h>

#include <array>
#include <random>
#include <vector>

#include "spatial/cell_balls.h"
#include "spatial/facet_balls.h"
#include "spatial/gamma_facet.h"
#include "tests/point_families.h"

namespace stream_recon {
namespace {

struct Cloud {
  Cloud() {
    std::mt19937_64 random(1);
    std::vector<Point3> points;
    for (int i = 0; i < 20000; ++i) points.push_back(families::random_point(random));
    if (delaunay.insert(points) != Delaunay::Outcome::kDone) return;
    const CellView cells = delaunay.view();
    for (CellId c = 0; c < cells.slots(); ++c) {
      if (cells.is_live(c) && !cells.is_infinite(c)) finite.push_back(c);
    }
  }
  Delaunay delaunay;
  std::vector<CellId> finite;
};

/// Each tetrahedron has two facets as its share.
void estimated(benchmark::State& state) {
  const Cloud cloud;
  BallEstimator estimator(cloud.delaunay.view());
  std::vector<CellBall> balls(cloud.finite.size());
  const GammaCriterion criterion(90);
  for (auto _ : state) {
    estimator.estimate(cloud.finite, balls);
    for (std::size_t i = 1; i < balls.size(); ++i) {
      benchmark::DoNotOptimize(criterion.judge(balls[i].from(0), balls[i - 1].from(1)));
      benchmark::DoNotOptimize(criterion.judge(balls[i].from(2), balls[i - 1].from(3)));
    }
  }
  state.SetItemsProcessed(state.iterations() * 2 * static_cast<int64_t>(balls.size()));
}

void accurate(benchmark::State& state) {
  const Cloud cloud;
  const CellView cells = cloud.delaunay.view();
  const GammaCriterion criterion(90);
  for (auto _ : state) {
    for (const CellId cell : cloud.finite) {
      for (int side = 0; side < 2; ++side) {
        const CellId beyond = cells.neighbor(cell, side);
        if (cells.is_infinite(beyond)) continue;
        const auto v = cells.facet(cell, side);
        const VertexId across = cells.vertex(beyond, cells.mirror_index(cell, side));
        benchmark::DoNotOptimize(criterion.takes(
            facet_balls({cells.point(v[0]), cells.point(v[1]), cells.point(v[2])},
                        cells.point(cells.vertex(cell, side)), cells.point(across))));
      }
    }
  }
  state.SetItemsProcessed(state.iterations() * 2 * static_cast<int64_t>(cloud.finite.size()));
}

BENCHMARK(estimated)->Name("gamma_facet/estimated");
BENCHMARK(accurate)->Name("gamma_facet/accurate");

}  // namespace
}  // namespace stream_recon
