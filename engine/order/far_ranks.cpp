#include "engine/order/far_ranks.h"

#include "engine/order/point_store.h"

namespace stream_recon {
namespace {

constexpr std::size_t kBatch = 1 << 12;

}  // namespace

std::vector<std::uint32_t> far_ranks(const CloudSummary& cloud, const StageContext& context) {
  std::vector<std::uint32_t> ranks;
  PointStoreReader store(context.scratch, kPointStore);
  std::vector<StoredPoint> batch(kBatch);
  std::uint32_t rank = 0;
  while (const std::size_t count = store.read(batch)) {
    for (std::size_t i = 0; i < count; ++i, ++rank) {
      if (batch[i].input_index >= cloud.points) ranks.push_back(rank);
    }
  }
  return ranks;
}

}  // namespace stream_recon
