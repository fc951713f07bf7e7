// The guests a window begins with: a halo around the owned points and a coarse sample of the rest,
// denser near, sparser far.
//
// Guarantees: none that exactness needs; a good choice saves rounds, a bad one costs time.
// Thread rule: pure but for the reader. Cost: about 1 % of the window's triangulation.
#pragma once

#include <vector>

#include "engine/windows/index_reader.h"
#include "engine/windows/owned_range.h"

namespace stream_recon {

struct GuestSampleOptions {
  /// Leaves nearer to the owned points than this many of their own diagonals come whole.
  double halo = 0.5;
  /// Nodes farther than this many of their own diagonals give one point.
  double far = 1.5;
};

struct GuestSample {
  std::vector<index_layout::LeafNumber> leaves;  ///< ascending
  std::vector<PointRank> singles;
};

/// \throw IoError
GuestSample sample_guests(const CloudIndex& index, IndexReader& reader, const OwnedRange& owned,
                          const GuestSampleOptions& options);

}  // namespace stream_recon
