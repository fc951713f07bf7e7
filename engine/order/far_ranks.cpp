#include "engine/order/far_ranks.h"

#include "engine/each_record.h"
#include "engine/order/point_store.h"

namespace stream_recon {

std::vector<std::uint32_t> far_ranks(const CloudSummary& cloud, const StageContext& context) {
  std::vector<std::uint32_t> ranks;
  std::uint32_t rank = 0;
  for_each_record<StoredPoint>(context, kPointStore, [&](const StoredPoint& stored) {
    if (stored.input_index >= cloud.points) ranks.push_back(rank);
    ++rank;
  });
  return ranks;
}

}  // namespace stream_recon
