// Samples of a known solid as a stream of points.
//
// Guarantees: as of clouds (cloud.h). The metadata of grid samplings have the grid's spacing.
// Memory: SolidGridScan's. Thread rule: one reader.
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "io/point_source.h"
#include "tools/clouds/known_solid.h"

namespace stream_recon {

enum class SolidSampling { kRandom, kNoisy, kCrossings, kFaces, kCentres };

/// What people call them, in the order of the enumeration.
inline constexpr std::array kSolidSamplingNames{"random", "noisy", "crossings", "faces", "centres"};

struct SolidSampleOptions {
  SolidOptions solid;
  SolidSampling sampling = SolidSampling::kRandom;
  std::uint64_t points = 1000000;  ///< exact for random samples; grids come close
  std::uint64_t seed = 1;          ///< of random and noisy samples
  std::uint32_t slice_step = 3;    ///< of grids, pixels, 1 to 1000
  /// kNoisy: standard deviation along the normal, in units of the mean spacing
  /// sqrt(area / points), 0 to 10.
  double noise = 0.25;
};

/// \throw std::invalid_argument an option out of range
std::unique_ptr<PointSource> sample_solid(const SolidSampleOptions& options);

}  // namespace stream_recon
