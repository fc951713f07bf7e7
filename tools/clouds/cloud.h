// Seeded synthetic clouds of any size, as streams of points.
//
// Guarantees: the points are a function of the options alone, the same bits on every machine;
// memory does not grow with the count (but with its square root for shells and other samples on a
// grid: a few tables of a side's length). announced_count() is always there and exact.
// Thread rule: one reader.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "io/point_source.h"
#include "tools/clouds/solid_samples.h"

namespace stream_recon {

struct CloudOptions {
  std::string kind;                ///< one of cloud_kinds()
  std::uint64_t points = 1000000;  ///< exact; shell and other samples on a grid come close
  std::uint64_t seed = 1;          ///< of the random kinds; lattice and grids ignore it
  std::uint32_t slice_step = 3;    ///< of grids: distance of slices in pixels, 1 .. 1000
  SolidSampling sampling = SolidSampling::kRandom;  ///< of solids; other kinds have but one
  double noise = 0.25;  ///< of noisy samples, in units of the mean spacing, 0 .. 10
  double width = 0;     ///< of pair and plate, SolidOptions::width
};

struct CloudKind {
  std::string_view name;
  std::string_view description;
};

std::span<const CloudKind> cloud_kinds();

/// \throw std::invalid_argument unknown kind, an option out of range, a sampling of no solid
std::unique_ptr<PointSource> make_cloud(const CloudOptions& options);

}  // namespace stream_recon
