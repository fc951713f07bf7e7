// Determinants of four cells at once, one in each lane of the AVX2 registers: what the in-sphere
// and the power test have in common.
//
// Guarantees: the operations of determinants.h and predicates_filter.h in the same order, so that
// every lane has their bits. For files of the kernel alone. Thread rule: pure functions.
#pragma once

#if defined(__x86_64__)

#include <immintrin.h>

#include "spatial/sphere_batch.h"

namespace stream_recon::detail {

#define STREAM_RECON_AVX2 __attribute__((target("avx2"))) inline

/// Four vectors from the query, one a lane, by coordinate.
struct Rows {
  __m256d x, y, z;
};

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
/// |a b c| from the heights and the minors of the other two coordinates.
STREAM_RECON_AVX2 __m256d determinant(const Rows& a, const Rows& b, const Rows& c, __m256d bc,
                                      __m256d ac, __m256d ab) {
  return _mm256_add_pd(_mm256_sub_pd(_mm256_mul_pd(a.z, bc), _mm256_mul_pd(b.z, ac)),
                       _mm256_mul_pd(c.z, ab));
}
STREAM_RECON_AVX2 unsigned mask_of(__m256d lanes) {
  return static_cast<unsigned>(_mm256_movemask_pd(lanes));
}

/// The corners of four cells, their lifts, and what bounds the lifts.
struct LiftedRows {
  Rows a, b, c, d;
  __m256d lift_a, lift_b, lift_c, lift_d;
  __m256d top;
};

/// Signs of lift(a) |b c d| - lift(b) |a c d| + lift(c) |a b d| - lift(d) |a b c|. \param error
/// over the product of the largest differences and the top lift. \param is_exact lanes without
/// error
STREAM_RECON_AVX2 SphereBatch signs_of(const LiftedRows& p, double error, __m256d is_exact) {
  const __m256d ab = cross_xy(p.a, p.b);
  const __m256d ac = cross_xy(p.a, p.c);
  const __m256d ad = cross_xy(p.a, p.d);
  const __m256d bc = cross_xy(p.b, p.c);
  const __m256d bd = cross_xy(p.b, p.d);
  const __m256d cd = cross_xy(p.c, p.d);
  const __m256d abc = determinant(p.a, p.b, p.c, bc, ac, ab);
  const __m256d abd = determinant(p.a, p.b, p.d, bd, ad, ab);
  const __m256d acd = determinant(p.a, p.c, p.d, cd, ad, ac);
  const __m256d bcd = determinant(p.b, p.c, p.d, cd, bd, bc);
  const __m256d value =
      _mm256_add_pd(_mm256_sub_pd(_mm256_mul_pd(p.lift_a, bcd), _mm256_mul_pd(p.lift_b, acd)),
                    _mm256_sub_pd(_mm256_mul_pd(p.lift_c, abd), _mm256_mul_pd(p.lift_d, abc)));
  const __m256d x = largest(p.a.x, p.b.x, p.c.x, p.d.x);
  const __m256d y = largest(p.a.y, p.b.y, p.c.y, p.d.y);
  const __m256d z = largest(p.a.z, p.b.z, p.c.z, p.d.z);
  const __m256d product = _mm256_mul_pd(_mm256_mul_pd(_mm256_mul_pd(x, y), z), p.top);
  const __m256d bound = _mm256_andnot_pd(is_exact, _mm256_mul_pd(_mm256_set1_pd(error), product));
  const __m256d zero = _mm256_setzero_pd();
  return {mask_of(_mm256_cmp_pd(value, bound, _CMP_GT_OQ)),
          mask_of(_mm256_cmp_pd(value, _mm256_sub_pd(zero, bound), _CMP_LT_OQ)),
          mask_of(_mm256_and_pd(_mm256_cmp_pd(bound, zero, _CMP_EQ_OQ),
                                _mm256_cmp_pd(value, zero, _CMP_EQ_OQ)))};
}

/// Lanes whose differences are all at most `reach`.
STREAM_RECON_AVX2 __m256d are_within(const LiftedRows& p, double reach) {
  const __m256d x = largest(p.a.x, p.b.x, p.c.x, p.d.x);
  const __m256d y = largest(p.a.y, p.b.y, p.c.y, p.d.y);
  const __m256d z = largest(p.a.z, p.b.z, p.c.z, p.d.z);
  return _mm256_cmp_pd(_mm256_max_pd(_mm256_max_pd(x, y), z), _mm256_set1_pd(reach), _CMP_LE_OQ);
}

}  // namespace stream_recon::detail

#endif
