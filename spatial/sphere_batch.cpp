#include "spatial/sphere_batch.h"

#include "spatial/predicates_filter.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

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

#define STREAM_RECON_AVX2 __attribute__((target("avx2"))) inline

// Four vectors from the query, one a lane, by coordinate.
struct Rows {
  __m256d x, y, z;
};

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

STREAM_RECON_AVX2 __m256d cross_xy(const Rows& a, const Rows& b) {
  return _mm256_sub_pd(_mm256_mul_pd(a.x, b.y), _mm256_mul_pd(b.x, a.y));
}
STREAM_RECON_AVX2 __m256d squared_length(const Rows& a) {
  return _mm256_add_pd(_mm256_add_pd(_mm256_mul_pd(a.x, a.x), _mm256_mul_pd(a.y, a.y)),
                       _mm256_mul_pd(a.z, a.z));
}
STREAM_RECON_AVX2 __m256d magnitude(__m256d a) {
  return _mm256_andnot_pd(_mm256_set1_pd(-0.0), a);
}
STREAM_RECON_AVX2 __m256d largest(__m256d a, __m256d b, __m256d c, __m256d d) {
  return _mm256_max_pd(_mm256_max_pd(magnitude(a), magnitude(b)),
                       _mm256_max_pd(magnitude(c), magnitude(d)));
}
// |a b c| from the heights and the minors of the other two coordinates.
STREAM_RECON_AVX2 __m256d determinant(const Rows& a, const Rows& b, const Rows& c, __m256d bc,
                                      __m256d ac, __m256d ab) {
  return _mm256_add_pd(_mm256_sub_pd(_mm256_mul_pd(a.z, bc), _mm256_mul_pd(b.z, ac)),
                       _mm256_mul_pd(c.z, ab));
}
STREAM_RECON_AVX2 unsigned mask_of(__m256d lanes) {
  return static_cast<unsigned>(_mm256_movemask_pd(lanes));
}

}  // namespace

__attribute__((target("avx2"))) SphereBatch test_spheres_avx2(
    const std::array<const Cell*, 4>& cells, const Point3* points, const PaddedPoint& query,
    double exact_reach) {
  const __m256d origin = _mm256_load_pd(&query.point.x);
  const Rows a = load_rows(cells, 0, points, origin);
  const Rows b = load_rows(cells, 1, points, origin);
  const Rows c = load_rows(cells, 2, points, origin);
  const Rows d = load_rows(cells, 3, points, origin);

  const __m256d ab = cross_xy(a, b);
  const __m256d ac = cross_xy(a, c);
  const __m256d ad = cross_xy(a, d);
  const __m256d bc = cross_xy(b, c);
  const __m256d bd = cross_xy(b, d);
  const __m256d cd = cross_xy(c, d);
  const __m256d abc = determinant(a, b, c, bc, ac, ab);
  const __m256d abd = determinant(a, b, d, bd, ad, ab);
  const __m256d acd = determinant(a, c, d, cd, ad, ac);
  const __m256d bcd = determinant(b, c, d, cd, bd, bc);
  const __m256d lift_a = squared_length(a);
  const __m256d lift_b = squared_length(b);
  const __m256d lift_c = squared_length(c);
  const __m256d lift_d = squared_length(d);
  // Inside is positive: |a|^2 bcd - |b|^2 acd + |c|^2 abd - |d|^2 abc.
  const __m256d value =
      _mm256_add_pd(_mm256_sub_pd(_mm256_mul_pd(lift_a, bcd), _mm256_mul_pd(lift_b, acd)),
                    _mm256_sub_pd(_mm256_mul_pd(lift_c, abd), _mm256_mul_pd(lift_d, abc)));

  const __m256d x = largest(a.x, b.x, c.x, d.x);
  const __m256d y = largest(a.y, b.y, c.y, d.y);
  const __m256d z = largest(a.z, b.z, c.z, d.z);
  const __m256d lift = largest(lift_a, lift_b, lift_c, lift_d);
  const __m256d reach = _mm256_max_pd(_mm256_max_pd(x, y), z);
  const __m256d product = _mm256_mul_pd(_mm256_mul_pd(_mm256_mul_pd(x, y), z), lift);
  const __m256d bound = _mm256_mul_pd(_mm256_set1_pd(kInSphereError), product);
  const __m256d is_exact = _mm256_cmp_pd(reach, _mm256_set1_pd(exact_reach), _CMP_LE_OQ);
  const __m256d error = _mm256_andnot_pd(is_exact, bound);
  const __m256d zero = _mm256_setzero_pd();
  return {mask_of(_mm256_cmp_pd(value, error, _CMP_GT_OQ)),
          mask_of(_mm256_cmp_pd(value, _mm256_sub_pd(zero, error), _CMP_LT_OQ)),
          mask_of(_mm256_and_pd(_mm256_cmp_pd(error, zero, _CMP_EQ_OQ),
                                _mm256_cmp_pd(value, zero, _CMP_EQ_OQ)))};
}
#endif

SphereBatchTest select_sphere_batch_test() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) return test_spheres_avx2;
#endif
  return test_spheres_portable;
}

}  // namespace stream_recon::detail
