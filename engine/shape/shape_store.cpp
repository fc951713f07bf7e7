#include "engine/shape/shape_store.h"

#include <algorithm>
#include <string>

namespace stream_recon {
namespace {

constexpr std::size_t kBatch = 1 << 12;

std::string window_file(std::uint64_t first_rank) {
  return "shape_window_" + std::to_string(first_rank);
}

}  // namespace

void write_shape_window(ScratchDirectory& scratch, std::uint64_t first_rank,
                        std::span<const ShapeFace> faces) {
  auto file = create_records<ShapeFace>(scratch, window_file(first_rank), kShapeBlock);
  file.append(faces);
  file.finish();
}

// A face lies in the window of its first pole, and windows of later samples have poles of larger
// numbers.
void store_shape(std::vector<std::uint64_t> first_ranks, const StageContext& context) {
  const Reservation memory = context.budget.reserve(
      record_file_memory(kShapeBlock) + record_cursor_memory(kShapeBlock), "the power shape");
  std::sort(first_ranks.begin(), first_ranks.end());
  auto store = create_records<ShapeFace>(context.scratch, kShapeStore, kShapeBlock);
  std::vector<ShapeFace> batch(kBatch);
  for (const std::uint64_t first_rank : first_ranks) {
    {
      ScratchReader<ShapeFace> reader(context.scratch, window_file(first_rank));
      while (const std::size_t count = reader.read(batch)) {
        context.stop.check();
        store.append(std::span<const ShapeFace>(batch).first(count));
      }
    }
    context.scratch.remove(window_file(first_rank));
  }
  store.finish();
}

}  // namespace stream_recon
