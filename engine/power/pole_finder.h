// The pole store by number and by name, for the windows of the power diagram.
//
// Guarantees: a pole's number is its position in the store, so numbers ascend by name. Thread rule:
// PoleIndex is const once made and thread-safe, a PoleFinder belongs to one thread. Memory:
// PoleIndex 16 bytes for 2340 poles and kPageMemory a page; a finder kMemory. Cost: one pass over
// the store to make the index; then about 150 ns a name where pages are in memory.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "engine/poles/pole_store.h"
#include "engine/windows/page_cache.h"
#include "io/block_codec.h"
#include "io/scratch_directory.h"
#include "spatial/coordinate_range.h"

namespace stream_recon {

/// Position of a pole in the store.
using PoleNumber = std::uint32_t;
inline constexpr PoleNumber kNoPole = std::numeric_limits<PoleNumber>::max();

/// The ball as a site of the power diagram: its weight is the squared radius, rounded.
inline WeightedPoint3 site_of(const Pole& pole) {
  return {pole.centre, pole.radius * pole.radius};
}

struct PolePage {
  std::vector<Pole> poles;
};

struct NumberedPole {
  PoleNumber number;
  Pole pole;
};

class PoleIndex {
 public:
  static constexpr std::uint64_t kPageMemory = kPoleStoreBlock + 256;

  /// Reads the store once.
  /// \param pages blocks of the store that are kept in memory, for all threads; at least one
  /// \throw IoError; InputError more poles than numbers
  PoleIndex(const ScratchDirectory& scratch, std::uint64_t pages);

  PoleNumber count() const { return static_cast<PoleNumber>(file_.record_count()); }
  /// Of all sites.
  const CoordinateRange& range() const { return range_; }
  /// No two centres are farther from each other; units of the input.
  double reach() const { return reach_; }
  /// One of every so many, ascending: about kSome, from all over the cloud.
  const std::vector<NumberedPole>& some() const { return some_; }

 private:
  friend class PoleFinder;

  static constexpr PoleNumber kSome = 512;

  PoleFile file_;
  std::vector<NodeKey> first_;  ///< of each block
  CoordinateRange range_;
  double reach_ = 0;
  std::vector<NumberedPole> some_;
  mutable PageCache<PolePage> pages_;
};

class PoleFinder {
 public:
  /// Bytes.
  static constexpr std::uint64_t kMemory = 3 * kPoleStoreBlock + (std::uint64_t{1} << 18);

  /// \pre The index outlives the finder.
  explicit PoleFinder(const PoleIndex& index) : index_(index) {}

  PoleNumber count() const { return index_.count(); }
  /// \pre number < count(). The pole is valid until the next call. \throw IoError
  const Pole& pole(PoleNumber number);
  /// kNoPole if there is none of this name. \throw IoError
  PoleNumber find(const NodeKey& name);
  /// The first pole whose lowest rank is not below this; count() if there is none. \throw IoError
  PoleNumber lower_bound(std::uint32_t rank);

 private:
  static constexpr std::uint64_t kNone = std::numeric_limits<std::uint64_t>::max();

  const PolePage& page(std::uint64_t number);
  PoleNumber first_not_below(const NodeKey& name);

  const PoleIndex& index_;
  std::uint64_t number_ = kNone;
  PageCache<PolePage>::Pin pin_;
  BlockCodec codec_;
  std::vector<std::byte> stored_;
};

}  // namespace stream_recon
