// Sine and cosine whose bits are the same on every machine: sums and products only, where the C
// library's own differ between versions.
//
// Guarantees: absolute error below 1e-15 for |angle| <= 1000. Cost: about 20 multiplications.
#pragma once

namespace stream_recon {

struct SineCosine {
  double sine;
  double cosine;
};

/// \param angle radians, at most 1000 in magnitude
SineCosine sine_cosine(double angle);

inline constexpr double kPi = 3.14159265358979323846;

}  // namespace stream_recon
