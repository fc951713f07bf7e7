// The determinants of the geometric predicates, written once for every rung of the ladder:
// Number = double (fast, with error bounds) or a wide integer (exact while it fits).
//
// All rows are differences to one common point, so that the determinants are small for points
// close together.
#pragma once

namespace stream_recon::detail {

template <class Number, class Row>
Number cross_xy(const Row& a, const Row& b) {
  return Number(a.x) * Number(b.y) - Number(a.y) * Number(b.x);
}

template <class Number, class Row>
Number squared_length(const Row& a) {
  return Number(a.x) * Number(a.x) + Number(a.y) * Number(a.y) + Number(a.z) * Number(a.z);
}

/// |a b c|.
template <class Number, class Row>
Number determinant3(const Row& a, const Row& b, const Row& c) {
  return Number(a.z) * cross_xy<Number>(b, c) - Number(b.z) * cross_xy<Number>(a, c) +
         Number(c.z) * cross_xy<Number>(a, b);
}

template <class Number>
struct Lifts {
  Number a;
  Number b;
  Number c;
  Number d;
};

/// lift(a) |b c d| - lift(b) |a c d| + lift(c) |a b d| - lift(d) |a b c|.
template <class Number, class Row>
Number lifted_determinant(const Row& a, const Row& b, const Row& c, const Row& d,
                          const Lifts<Number>& lift) {
  const Number ab = cross_xy<Number>(a, b);
  const Number ac = cross_xy<Number>(a, c);
  const Number ad = cross_xy<Number>(a, d);
  const Number bc = cross_xy<Number>(b, c);
  const Number bd = cross_xy<Number>(b, d);
  const Number cd = cross_xy<Number>(c, d);
  const Number bcd = Number(b.z) * cd - Number(c.z) * bd + Number(d.z) * bc;
  const Number acd = Number(a.z) * cd - Number(c.z) * ad + Number(d.z) * ac;
  const Number abd = Number(a.z) * bd - Number(b.z) * ad + Number(d.z) * ab;
  const Number abc = Number(a.z) * bc - Number(b.z) * ac + Number(c.z) * ab;
  return (lift.a * bcd - lift.b * acd) + (lift.c * abd - lift.d * abc);
}

/// The same one dimension lower, in the projection to x and y, with lifts of any kind.
template <class Number, class Row>
Number lifted_determinant_xy(const Row& a, const Row& b, const Row& c, const Lifts<Number>& lift) {
  return lift.a * cross_xy<Number>(b, c) - lift.b * cross_xy<Number>(a, c) +
         lift.c * cross_xy<Number>(a, b);
}

}  // namespace stream_recon::detail
