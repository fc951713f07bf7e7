#include "spatial/power_batch.h"

#include "spatial/four_lanes.h"
#include "spatial/power_filter.h"

namespace stream_recon::detail {

SphereBatch test_powers_portable(const std::array<const Cell*, 4>& cells,
                                 const WeightedPoint3* sites, const WeightedPoint3& query,
                                 double exact_reach) {
  SphereBatch result{0, 0, 0};
  for (unsigned lane = 0; lane < 4; ++lane) {
    const Cell& cell = *cells[lane];
    const PowerEstimate estimate =
        estimate_power_test(sites[vertex_of(cell, 0)], sites[cell.vertex[1]], sites[cell.vertex[2]],
                            sites[cell.vertex[3]], query);
    const double error = estimate.is_exact(exact_reach) ? 0 : estimate.error;
    result.inside |= static_cast<unsigned>(estimate.value > error) << lane;
    result.outside |= static_cast<unsigned>(estimate.value < -error) << lane;
    result.cospherical |= static_cast<unsigned>(error == 0 && estimate.value == 0) << lane;
  }
  return result;
}

#if defined(__x86_64__)
namespace {

struct LoadedRows {
  Rows row;
  __m256d lift;
  __m256d top;  // of the lift: the sum of the magnitudes of what it is made of
};

STREAM_RECON_AVX2 LoadedRows load_rows(const std::array<const Cell*, 4>& cells, int vertex,
                                       const WeightedPoint3* sites, __m256d query) {
  __m256d p[4];
  for (int lane = 0; lane < 4; ++lane) {
    const double* at = &sites[cells[lane]->vertex[vertex] & ~kDead].point.x;
    p[lane] = _mm256_sub_pd(_mm256_loadu_pd(at), query);
  }
  const __m256d xz01 = _mm256_unpacklo_pd(p[0], p[1]);
  const __m256d yw01 = _mm256_unpackhi_pd(p[0], p[1]);
  const __m256d xz23 = _mm256_unpacklo_pd(p[2], p[3]);
  const __m256d yw23 = _mm256_unpackhi_pd(p[2], p[3]);
  const Rows row{_mm256_permute2f128_pd(xz01, xz23, 0x20), _mm256_permute2f128_pd(yw01, yw23, 0x20),
                 _mm256_permute2f128_pd(xz01, xz23, 0x31)};
  const __m256d weight = _mm256_permute2f128_pd(yw01, yw23, 0x31);
  const __m256d square = squared_length(row);
  return {row, _mm256_sub_pd(square, weight), _mm256_add_pd(square, magnitude(weight))};
}

}  // namespace

__attribute__((target("avx2"))) SphereBatch test_powers_avx2(
    const std::array<const Cell*, 4>& cells, const WeightedPoint3* sites,
    const WeightedPoint3& query, double exact_reach) {
  static_assert(sizeof(WeightedPoint3) == sizeof(__m256d));
  const __m256d origin = _mm256_loadu_pd(&query.point.x);
  const LoadedRows a = load_rows(cells, 0, sites, origin);
  const LoadedRows b = load_rows(cells, 1, sites, origin);
  const LoadedRows c = load_rows(cells, 2, sites, origin);
  const LoadedRows d = load_rows(cells, 3, sites, origin);
  const LiftedRows p{a.row,  b.row,  c.row,
                     d.row,  a.lift, b.lift,
                     c.lift, d.lift, largest(a.top, b.top, c.top, d.top)};
  const __m256d has_small_lifts =
      _mm256_cmp_pd(p.top, _mm256_set1_pd(3 * exact_reach * exact_reach), _CMP_LE_OQ);
  return signs_of(p, kPowerError, _mm256_and_pd(are_within(p, exact_reach), has_small_lifts));
}
#endif

PowerBatchTest select_power_batch_test() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) return test_powers_avx2;
#endif
  return test_powers_portable;
}

}  // namespace stream_recon::detail
