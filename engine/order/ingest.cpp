#include "engine/order/ingest.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "engine/order/far_points.h"
#include "engine/order/stored_point.h"
#include "engine/parallel_records.h"

namespace stream_recon {
namespace {

constexpr std::size_t kBatch = 1 << 14;
// A batch of points twice, and a reader's buffer.
constexpr std::uint64_t kMemory = kBatch * (sizeof(Point3) + sizeof(StoredPoint)) + (2 << 20);

bool is_float32(double x) {
  return static_cast<double>(static_cast<float>(x)) == x;
}

/// Counts the batch into the summary and appends its finite points to `kept`.
void take_batch(std::span<const Point3> batch, CloudSummary& summary,
                std::vector<StoredPoint>& kept) {
  for (const Point3& p : batch) {
    const std::uint64_t index = summary.points++;
    if (!is_finite(p)) {
      ++summary.rejected;
      continue;
    }
    summary.box.extend(p);
    summary.range.extend(p);
    summary.fits_float32 =
        summary.fits_float32 && is_float32(p.x) && is_float32(p.y) && is_float32(p.z);
    kept.push_back({p, index});
  }
}

void widen(std::optional<SampleSpacing>& spacing, const std::optional<SampleSpacing>& other) {
  if (!other) return;
  if (!spacing) spacing = other;
  for (std::size_t axis = 0; axis < spacing->size(); ++axis) {
    (*spacing)[axis] = std::max((*spacing)[axis], (*other)[axis]);
  }
}

}  // namespace

CloudSummary ingest(const IngestOptions& options, const StageContext& context) {
  const std::size_t blocks = blocks_at_once(kIngestBlock, context.budget);
  const Reservation memory = context.budget.reserve(
      kMemory + blocks * record_file_memory(kIngestBlock), "reading the input");
  auto spool = create_records<StoredPoint>(context.scratch, kIngestSpool, kIngestBlock, blocks);
  std::vector<Point3> batch(kBatch);
  std::vector<StoredPoint> kept;
  kept.reserve(kBatch);

  CloudSummary summary;
  for (const std::string& input : options.inputs) {
    const auto source = open_point_source(input, options.format);
    context.progress.begin_stage("ingest", source->announced_count().value_or(0), "points");
    while (const std::size_t count = source->read(batch)) {
      context.stop.check();
      kept.clear();
      take_batch({batch.data(), count}, summary, kept);
      spool.append(kept);
      context.progress.advance(count);
    }
    summary.bytes += source->bytes_read();
    widen(summary.spacing, source->metadata().spacing);
    context.progress.end_stage();
  }
  if (options.adds_far_points && !summary.box.empty()) {
    for (const Point3& p : far_points(summary.box)) {
      spool.append({p, summary.points + summary.far_points++});
      summary.range.extend(p);
      summary.box.extend(p);
    }
  }
  spool.finish();
  return summary;
}

}  // namespace stream_recon
