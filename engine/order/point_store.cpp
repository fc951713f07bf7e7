#include "engine/order/point_store.h"

#include <cstring>

namespace stream_recon {

void read_points(const PointStoreFile& store, std::span<const std::uint64_t> ranks,
                 std::vector<Point3>& points, std::vector<std::uint64_t>& input_indices) {
  BlockCursor cursor(store);
  points.reserve(points.size() + ranks.size());
  input_indices.reserve(input_indices.size() + ranks.size());
  std::span<const std::byte> block;
  std::uint64_t begin = 0;  // of the block, and its end
  std::uint64_t end = 0;
  for (const std::uint64_t rank : ranks) {
    if (rank >= end) {
      const std::uint64_t number = rank / store.records_per_block();
      block = cursor.block(number);
      begin = number * store.records_per_block();
      end = begin + store.records_in_block(number);
    }
    StoredPoint stored;
    std::memcpy(&stored, &block[(rank - begin) * sizeof stored], sizeof stored);
    points.push_back(stored.point);
    input_indices.push_back(stored.input_index);
  }
}

}  // namespace stream_recon
