// Determinants of integers of 128 bits. The limits on the differences M keep every intermediate
// result below 2^127; see the count of products in predicates_filter.h.
#include <algorithm>
#include <bit>
#include <cmath>

#include "spatial/determinants.h"
#include "spatial/predicates_exact.h"

namespace stream_recon::detail {
namespace {

__extension__ using Int128 = __int128;

struct IntegerRow {
  std::int64_t x;
  std::int64_t y;
  std::int64_t z;
};

// 6 M^3 < 2^127.
constexpr int kDeterminantBits = 41;
// 4 lifts of 3 M^2 times 6 M^3: 72 M^5 < 2^127.
constexpr int kInSphereBits = 24;
// 3 lifts of 3 M^2 times 2 M^2: 18 M^4 < 2^127.
constexpr int kInCircleBits = 30;

template <class Number>
int sign_of(const Number& value) {
  return (value > 0) - (value < 0);
}

// The rows as multiples of their own greatest common power of two, if they take at most `bits`.
template <std::size_t kRows>
bool to_integers(const std::array<Point3, kRows>& rows, double inverse_unit, int bits,
                 std::array<IntegerRow, kRows>& integers) {
  constexpr double kExact = 0x1p53;
  std::uint64_t all = 0;
  std::uint64_t top = 0;
  const auto convert = [&](double difference, std::int64_t& integer) {
    const double multiple = difference * inverse_unit;
    // A difference of 2^53 units may have been rounded to that.
    if (!(std::fabs(multiple) < kExact)) return false;
    integer = static_cast<std::int64_t>(multiple);
    const auto magnitude = static_cast<std::uint64_t>(std::abs(integer));
    all |= magnitude;
    top = std::max(top, magnitude);
    return true;
  };
  for (std::size_t i = 0; i < kRows; ++i) {
    if (!convert(rows[i].x, integers[i].x) || !convert(rows[i].y, integers[i].y) ||
        !convert(rows[i].z, integers[i].z)) {
      return false;
    }
  }
  if (all == 0) return true;
  const int shift = std::countr_zero(all);
  if (top >> shift > std::uint64_t{1} << bits) return false;
  for (IntegerRow& row : integers) {
    row.x >>= shift;
    row.y >>= shift;
    row.z >>= shift;
  }
  return true;
}

}  // namespace

IntegerSign integer_determinant_sign(const std::array<Point3, 3>& rows, double inverse_unit) {
  std::array<IntegerRow, 3> r;
  if (!to_integers(rows, inverse_unit, kDeterminantBits, r)) return {false, 0};
  return {true, sign_of(determinant3<Int128>(r[0], r[1], r[2]))};
}

IntegerSign integer_in_sphere_sign(const std::array<Point3, 4>& rows, double inverse_unit) {
  std::array<IntegerRow, 4> r;
  if (!to_integers(rows, inverse_unit, kInSphereBits, r)) return {false, 0};
  const Lifts<Int128> lift{squared_length<Int128>(r[0]), squared_length<Int128>(r[1]),
                           squared_length<Int128>(r[2]), squared_length<Int128>(r[3])};
  return {true, sign_of(lifted_determinant(r[0], r[1], r[2], r[3], lift))};
}

IntegerSign integer_in_circle_xy_sign(const std::array<Point3, 3>& rows, double inverse_unit) {
  std::array<IntegerRow, 3> r;
  if (!to_integers(rows, inverse_unit, kInCircleBits, r)) return {false, 0};
  const Lifts<Int128> lift{squared_length<Int128>(r[0]), squared_length<Int128>(r[1]),
                           squared_length<Int128>(r[2]), 0};
  return {true, sign_of(lifted_determinant_xy(r[0], r[1], r[2], lift))};
}

}  // namespace stream_recon::detail
