#include "tools/clouds/trigonometry.h"

#include <cmath>

namespace stream_recon {
namespace {

// pi / 2 as a sum: the first part has 33 bits, so that its multiples by small integers are exact.
constexpr double kHalfPiHigh = 0x1.921fb544p+0;
constexpr double kHalfPiLow = 0x1.0b4611a626331p-34;

// Taylor's series up to the 17th power: the rest is below 1e-19 for |r| <= pi / 4.
double sine_series(double r) {
  const double s = r * r;
  double sum = 1;
  for (int k = 16; k >= 2; k -= 2) sum = 1 - s * sum / (k * (k + 1));
  return r * sum;
}

double cosine_series(double r) {
  const double s = r * r;
  double sum = 1;
  for (int k = 17; k >= 1; k -= 2) sum = 1 - s * sum / (k * (k + 1));
  return sum;
}

}  // namespace

SineCosine sine_cosine(double angle) {
  const double quarter = std::floor(angle / (kHalfPiHigh + kHalfPiLow) + 0.5);
  const double r = (angle - quarter * kHalfPiHigh) - quarter * kHalfPiLow;
  const double s = sine_series(r);
  const double c = cosine_series(r);
  switch (static_cast<long>(quarter) & 3) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

}  // namespace stream_recon
