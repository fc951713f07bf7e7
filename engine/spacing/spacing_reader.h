// The spacings of points by rank, through a cache that all readers share.
//
// Thread rule: the cache is thread-safe, a reader belongs to one thread. Memory: the cache as told;
// a reader: kMemory. Cost: a few ns for a point of the page of the one before, about 50 ns for one
// of another page in the cache; ask for neighbours in the order of their ranks.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "engine/scratch_records.h"
#include "engine/spacing/spacing_stage.h"
#include "engine/windows/page_cache.h"
#include "io/block_codec.h"

namespace stream_recon {

/// Places beyond the end of the cloud hold 0.
struct SpacingPage {
  static constexpr std::size_t kPoints = kSpacingBlock / sizeof(float);

  std::array<float, kPoints> spacing;  ///< scaled (CloudIndex::scale)
};

class SpacingCache {
 public:
  /// The least and the most memory worth having for a cloud of so many points.
  static std::uint64_t least_memory(unsigned readers);
  static std::uint64_t most_memory(std::uint64_t point_count);
  /// What to give it of the memory that is available: a twenty-fourth, within these bounds.
  static std::uint64_t memory(std::uint64_t point_count, unsigned readers, std::uint64_t available);

  /// Of what measure_spacing() wrote for the index. \throw IoError
  SpacingCache(const ScratchDirectory& scratch, const CloudIndex& index, std::uint64_t memory);

  /// Of spacings over lengths of the input: CloudIndex::scale.
  double scale() const { return scale_; }

 private:
  friend class SpacingReader;

  double scale_;
  RecordFile<float> file_;
  PageCache<SpacingPage> pages_;
};

class SpacingReader {
 public:
  static constexpr std::uint64_t kMemory = record_cursor_memory(kSpacingBlock);

  explicit SpacingReader(SpacingCache& cache) : cache_(cache) {}

  /// Scaled (CloudIndex::scale), positive. \pre There is such a point. \throw IoError
  float at(PointRank rank) {
    const std::uint64_t page = rank / SpacingPage::kPoints;
    if (page != page_) load(page);
    return pin_->spacing[rank % SpacingPage::kPoints];
  }

 private:
  void load(std::uint64_t page);

  SpacingCache& cache_;
  std::uint64_t page_ = std::numeric_limits<std::uint64_t>::max();
  PageCache<SpacingPage>::Pin pin_;
  BlockCodec codec_;
  std::vector<std::byte> stored_;
};

}  // namespace stream_recon
