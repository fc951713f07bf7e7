// A sum of doubles that loses almost nothing: the error does not grow with the number of terms.
//
// Guarantees: a function of the terms and their order. Thread rule: a value. Source: Neumaier 1974.
#pragma once

#include <cmath>

namespace stream_recon {

class CompensatedSum {
 public:
  void add(double term) {
    const double sum = sum_ + term;
    lost_ += std::abs(sum_) >= std::abs(term) ? (sum_ - sum) + term : (term - sum) + sum_;
    sum_ = sum;
  }
  double value() const { return sum_ + lost_; }

 private:
  double sum_ = 0;
  double lost_ = 0;
};

}  // namespace stream_recon
