// Seeded synthetic clouds of any size, as streams of points.
//
// Guarantees: the points are a function of kind, count, seed and slice step alone, the same bits on
// every machine; memory does not grow with the count (but with its square root for shells: three
// tables of a side's length). announced_count() is always there and exact.
// Thread rule: one reader.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "io/point_source.h"

namespace stream_recon {

struct CloudOptions {
  std::string kind;                ///< one of cloud_kinds()
  std::uint64_t points = 1000000;  ///< exact for every kind but shell, which comes close
  std::uint64_t seed = 1;          ///< of the random kinds; lattice and shell ignore it
  std::uint32_t slice_step = 3;    ///< shell: distance of slices in pixels, 1 .. 1000
};

struct CloudKind {
  std::string_view name;
  std::string_view description;
};

std::span<const CloudKind> cloud_kinds();

/// \throw std::invalid_argument unknown kind, slice step out of range
std::unique_ptr<PointSource> make_cloud(const CloudOptions& options);

}  // namespace stream_recon
