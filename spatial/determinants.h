// The determinants of the geometric predicates, written once for every rung of the ladder: rows of
// doubles (fast, with error bounds) or of wide integers (exact, every product as wide as it must
// be).
//
// All rows are differences to one common point, so that the determinants are small for points
// close together.
#pragma once

namespace stream_recon::detail {

template <class Row>
auto cross_xy(const Row& a, const Row& b) {
  return a.x * b.y - a.y * b.x;
}

template <class Row>
auto squared_length(const Row& a) {
  return a.x * a.x + a.y * a.y + a.z * a.z;
}

/// |a b c|.
template <class Row>
auto determinant3(const Row& a, const Row& b, const Row& c) {
  return a.z * cross_xy(b, c) - b.z * cross_xy(a, c) + c.z * cross_xy(a, b);
}

/// What stands in the fourth column, of the rows a, b, c and d.
template <class Number>
struct Lifts {
  Number a;
  Number b;
  Number c;
  Number d{};  // not used in the plane
};
template <class Number>
Lifts(Number, Number, Number, Number) -> Lifts<Number>;
template <class Number>
Lifts(Number, Number, Number) -> Lifts<Number>;

/// lift(a) |b c d| - lift(b) |a c d| + lift(c) |a b d| - lift(d) |a b c|.
template <class Row, class Lift>
auto lifted_determinant(const Row& a, const Row& b, const Row& c, const Row& d,
                        const Lifts<Lift>& lift) {
  const auto ab = cross_xy(a, b);
  const auto ac = cross_xy(a, c);
  const auto ad = cross_xy(a, d);
  const auto bc = cross_xy(b, c);
  const auto bd = cross_xy(b, d);
  const auto cd = cross_xy(c, d);
  const auto bcd = b.z * cd - c.z * bd + d.z * bc;
  const auto acd = a.z * cd - c.z * ad + d.z * ac;
  const auto abd = a.z * bd - b.z * ad + d.z * ab;
  const auto abc = a.z * bc - b.z * ac + c.z * ab;
  return (lift.a * bcd - lift.b * acd) + (lift.c * abd - lift.d * abc);
}

/// The same one dimension lower, in the projection to x and y, with lifts of any kind.
template <class Row, class Lift>
auto lifted_determinant_xy(const Row& a, const Row& b, const Row& c, const Lifts<Lift>& lift) {
  return lift.a * cross_xy(b, c) - lift.b * cross_xy(a, c) + lift.c * cross_xy(a, b);
}

}  // namespace stream_recon::detail
