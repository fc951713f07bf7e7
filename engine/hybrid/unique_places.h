// A vertex of the crust for each of some samples, no vertex twice.
//
// Guarantees: the nearest pairs are made first; of equal ones the lower sample, then the lower
// vertex. Thread rule: pure. Cost: n log n.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "spatial/neighbors.h"
#include "spatial/point.h"

namespace stream_recon {

inline constexpr std::uint32_t kNoPlace = std::numeric_limits<std::uint32_t>::max();

/// Whether the place may be the sample's; positions in what unique_places() is given.
using MayBePlace = std::function<bool(std::uint32_t sample, std::uint32_t place)>;

struct UniquePlacesOptions {
  std::size_t nearest = 12;  ///< places looked at for a sample
};

/// \return a place of each sample, or kNoPlace
std::vector<std::uint32_t> unique_places(std::span<const Point3> samples, const Neighbors& places,
                                         const MayBePlace& may_be,
                                         const UniquePlacesOptions& options = {});

}  // namespace stream_recon
