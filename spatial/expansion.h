// Exact arithmetic on sums of doubles: an expansion is an unevaluated sum of doubles that do not
// overlap, smallest first, without zeros.
//
// Guarantees: sums, differences and products are exact as long as no product overflows or loses
// bits to underflow (CoordinateRange). Capacities are compile-time bounds; everything is on the
// stack. Costs about 10 ns an elementary sum or product of components.
// Source: Shewchuk 1997 ("Adaptive precision floating-point arithmetic and fast robust geometric
// predicates", sections 2.4 to 2.6); splitting after Veltkamp and Dekker 1971.
#pragma once

#include <algorithm>
#include <array>

namespace stream_recon {

namespace detail {

struct DoublePair {
  double high;
  double low;
};

/// high + low == a + b exactly; likewise below.
inline DoublePair two_sum(double a, double b) {
  const double sum = a + b;
  const double b_virtual = sum - a;
  const double a_virtual = sum - b_virtual;
  return {sum, (a - a_virtual) + (b - b_virtual)};
}

DoublePair two_product(double a, double b);

/// Write e + f, e * factor to h and return its size; h holds size_e + size_f, 2 * size_e. No alias.
int expansion_sum(const double* e, int size_e, const double* f, int size_f, double* h);
int expansion_scale(const double* e, int size_e, double factor, double* h);

}  // namespace detail

template <int kCapacity>
class Expansion {
 public:
  Expansion() = default;
  explicit Expansion(double value) : size_(value != 0) { components_[0] = value; }
  Expansion(const Expansion& other) { *this = other; }
  Expansion& operator=(const Expansion& other) {
    size_ = other.size_;
    std::copy_n(other.components_.data(), size_, components_.data());
    return *this;
  }
  ~Expansion() = default;

  int size() const { return size_; }
  int sign() const {
    if (size_ == 0) return 0;
    return components_[size_ - 1] > 0 ? 1 : -1;
  }

  Expansion operator-() const {
    Expansion negated;
    negated.size_ = size_;
    for (int i = 0; i < size_; ++i) negated.components_[i] = -components_[i];
    return negated;
  }

  template <int kOther>
  Expansion<kCapacity + kOther> operator+(const Expansion<kOther>& other) const {
    Expansion<kCapacity + kOther> sum;
    sum.size_ = detail::expansion_sum(components_.data(), size_, other.components_.data(),
                                      other.size_, sum.components_.data());
    return sum;
  }

  template <int kOther>
  Expansion<kCapacity + kOther> operator-(const Expansion<kOther>& other) const {
    return *this + (-other);
  }

  Expansion<2 * kCapacity> operator*(double factor) const {
    Expansion<2 * kCapacity> product;
    product.size_ =
        detail::expansion_scale(components_.data(), size_, factor, product.components_.data());
    return product;
  }

  template <int kOther>
  Expansion<2 * kCapacity * kOther> operator*(const Expansion<kOther>& other) const {
    Expansion<2 * kCapacity * kOther> product;
    Expansion<2 * kCapacity * kOther> partial;
    for (int i = 0; i < other.size_; ++i) {
      const Expansion<2 * kCapacity> scaled = *this * other.components_[i];
      partial = product;
      product.size_ = detail::expansion_sum(partial.components_.data(), partial.size_,
                                            scaled.components_.data(), scaled.size_,
                                            product.components_.data());
    }
    return product;
  }

 private:
  template <int kOther>
  friend class Expansion;

  int size_ = 0;
  std::array<double, kCapacity> components_;
};

}  // namespace stream_recon
