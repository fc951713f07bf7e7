#include "spatial/sphere_batch.h"

#include "spatial/four_lanes.h"
#include "spatial/predicates_filter.h"

namespace stream_recon::detail {

SphereBatch test_spheres_portable(const std::array<const Cell*, 4>& cells, const Point3* points,
                                  const PaddedPoint& query, double exact_reach) {
  SphereBatch result{0, 0, 0};
  for (unsigned lane = 0; lane < 4; ++lane) {
    const Cell& cell = *cells[lane];
    const Estimate estimate =
        estimate_in_sphere(difference(points[vertex_of(cell, 0)], query.point),
                           difference(points[cell.vertex[1]], query.point),
                           difference(points[cell.vertex[2]], query.point),
                           difference(points[cell.vertex[3]], query.point));
    const double error = estimate.reach <= exact_reach ? 0 : estimate.error;
    result.inside |= static_cast<unsigned>(estimate.value > error) << lane;
    result.outside |= static_cast<unsigned>(estimate.value < -error) << lane;
    result.cospherical |= static_cast<unsigned>(error == 0 && estimate.value == 0) << lane;
  }
  return result;
}

#if defined(__x86_64__)
namespace {

STREAM_RECON_AVX2 Rows load_rows(const std::array<const Cell*, 4>& cells, int vertex,
                                 const Point3* points, __m256d query) {
  __m256d p[4];
  for (int lane = 0; lane < 4; ++lane) {
    const double* at = &points[cells[lane]->vertex[vertex] & ~kDead].x;
    p[lane] = _mm256_sub_pd(_mm256_loadu_pd(at), query);
  }
  const __m256d xz01 = _mm256_unpacklo_pd(p[0], p[1]);
  const __m256d y01 = _mm256_unpackhi_pd(p[0], p[1]);
  const __m256d xz23 = _mm256_unpacklo_pd(p[2], p[3]);
  const __m256d y23 = _mm256_unpackhi_pd(p[2], p[3]);
  return {_mm256_permute2f128_pd(xz01, xz23, 0x20), _mm256_permute2f128_pd(y01, y23, 0x20),
          _mm256_permute2f128_pd(xz01, xz23, 0x31)};
}

}  // namespace

__attribute__((target("avx2"))) SphereBatch test_spheres_avx2(
    const std::array<const Cell*, 4>& cells, const Point3* points, const PaddedPoint& query,
    double exact_reach) {
  const __m256d origin = _mm256_load_pd(&query.point.x);
  LiftedRows p;
  p.a = load_rows(cells, 0, points, origin);
  p.b = load_rows(cells, 1, points, origin);
  p.c = load_rows(cells, 2, points, origin);
  p.d = load_rows(cells, 3, points, origin);
  p.lift_a = squared_length(p.a);
  p.lift_b = squared_length(p.b);
  p.lift_c = squared_length(p.c);
  p.lift_d = squared_length(p.d);
  p.top = largest(p.lift_a, p.lift_b, p.lift_c, p.lift_d);
  return signs_of(p, kInSphereError, are_within(p, exact_reach));
}
#endif

SphereBatchTest select_sphere_batch_test() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) return test_spheres_avx2;
#endif
  return test_spheres_portable;
}

}  // namespace stream_recon::detail
