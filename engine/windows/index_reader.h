// Pages of the index and of the point store for one window, through caches that all windows share.
//
// Thread rule: the shared parts are thread-safe, a reader belongs to one thread.
// Memory: IndexCaches: as told; a reader: two codecs, about 2 MB, and the pages it pins.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "engine/order/point_store.h"
#include "engine/windows/cloud_index.h"
#include "engine/windows/page_cache.h"
#include "io/block_codec.h"

namespace stream_recon {

struct NodePage {
  std::array<NodeBounds, index_layout::kPageNodes> nodes;
};

/// A block of the point store by coordinate, so that vector instructions apply. Places beyond the
/// end of the cloud hold NaN.
struct PointPage {
  static constexpr std::size_t kPoints = kPointStoreBlock / sizeof(StoredPoint);
  static_assert(kPoints % index_layout::kLeafPoints == 0);

  std::array<double, kPoints> x, y, z;  ///< scaled (CloudIndex::scale)
  std::array<std::uint64_t, kPoints> input_index;
  double unscale = 1;

  Point3 scaled_point(std::size_t i) const { return {x[i], y[i], z[i]}; }
  Point3 point(std::size_t i) const { return {x[i] * unscale, y[i] * unscale, z[i] * unscale}; }
};

/// Files and caches behind all readers.
class IndexCaches {
 public:
  /// The least and the most memory worth having for a cloud of so many points.
  static std::uint64_t least_memory(unsigned readers);
  static std::uint64_t most_memory(std::uint64_t point_count);

  /// \throw IoError
  IndexCaches(const ScratchDirectory& scratch, const CloudIndex& index, std::uint64_t memory);

 private:
  friend class IndexReader;

  double scale_;
  RecordFile<NodeBounds> node_file_;
  RecordFile<StoredPoint> point_file_;
  PageCache<NodePage> nodes_;
  PageCache<PointPage> points_;
};

class IndexReader {
 public:
  static constexpr std::uint64_t kMemory = std::uint64_t{2} << 20;

  explicit IndexReader(IndexCaches& caches) : caches_(caches), block_(PointPage::kPoints) {}

  /// Valid until the next call. \throw IoError
  const NodePage& nodes(std::uint64_t page);
  /// The page that has a rank; valid until the next call. \throw IoError
  const PointPage& points_at(PointRank rank);
  StoredPoint point(PointRank rank);

  /// Pages for those who keep several. \throw IoError
  PageCache<NodePage>::Pin pin_nodes(std::uint64_t page);
  PageCache<PointPage>::Pin pin_points(std::uint64_t page);

 private:
  static constexpr std::uint64_t kNone = std::numeric_limits<std::uint64_t>::max();

  IndexCaches& caches_;
  std::uint64_t node_page_ = kNone;
  std::uint64_t point_page_ = kNone;
  PageCache<NodePage>::Pin node_pin_;
  PageCache<PointPage>::Pin point_pin_;
  BlockCodec codec_;
  std::vector<std::byte> stored_;
  std::vector<StoredPoint> block_;
};

}  // namespace stream_recon
