#include "spatial/expansion.h"

#include <cmath>

namespace stream_recon::detail {
namespace {

// Splits a double in two halves of 26 bits (the sign of the lower half holds the missing bit).
DoublePair split(double a) {
  constexpr double kSplitter = 0x1p27 + 1;
  const double c = kSplitter * a;
  const double high = c - (c - a);
  return {high, a - high};
}

// two_sum() for |a| >= |b|.
DoublePair ordered_two_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

DoublePair two_product(double a, double b, const DoublePair& b_split) {
  const double product = a * b;
  const DoublePair a_split = split(a);
  const double error = ((a_split.high * b_split.high - product) + a_split.high * b_split.low +
                        a_split.low * b_split.high) +
                       a_split.low * b_split.low;
  return {product, error};
}

// Appends a component unless it is zero.
class Appender {
 public:
  explicit Appender(double* h) : h_(h) {}
  void append(double component) {
    h_[size_] = component;
    size_ += component != 0;
  }
  /// The last component goes where there may be no room for a zero.
  int finish(double component) {
    if (component != 0) h_[size_++] = component;
    return size_;
  }

 private:
  double* h_;
  int size_ = 0;
};

}  // namespace

DoublePair two_product(double a, double b) {
  return two_product(a, b, split(b));
}

// Shewchuk's fast expansion sum: merges by magnitude and carries the running sum upwards.
int expansion_sum(const double* e, int size_e, const double* f, int size_f, double* h) {
  int i = 0;
  int j = 0;
  const auto next = [&] {
    const bool from_e = j == size_f || (i < size_e && std::fabs(e[i]) < std::fabs(f[j]));
    return from_e ? e[i++] : f[j++];
  };
  const int total = size_e + size_f;
  if (total == 0) return 0;
  Appender out(h);
  double carried = next();
  for (int k = 1; k < total; ++k) {
    const DoublePair sum = two_sum(carried, next());
    out.append(sum.low);
    carried = sum.high;
  }
  return out.finish(carried);
}

int expansion_scale(const double* e, int size_e, double factor, double* h) {
  if (size_e == 0 || factor == 0) return 0;
  Appender out(h);
  const DoublePair factor_split = split(factor);
  const DoublePair first = two_product(e[0], factor, factor_split);
  out.append(first.low);
  double carried = first.high;
  for (int i = 1; i < size_e; ++i) {
    const DoublePair product = two_product(e[i], factor, factor_split);
    const DoublePair low = two_sum(carried, product.low);
    out.append(low.low);
    const DoublePair high = ordered_two_sum(product.high, low.high);
    out.append(high.low);
    carried = high.high;
  }
  return out.finish(carried);
}

}  // namespace stream_recon::detail
