#include "tools/sampling/each_label.h"

#include <algorithm>
#include <span>

#include "io/error.h"
#include "tools/sampling/object_scan.h"

namespace stream_recon {
namespace {

ObjectScanOptions scan_options(const SamplingOptions& options, const LabelExtent& extent) {
  return {options.kind, options.smoothing, extent.box};
}

/// One label on its way.
class LabelWalk {
 public:
  LabelWalk(RecentSlices& slices, const LabelExtent& extent, const ObjectScanOptions& options,
            const Placement& placement, std::unique_ptr<LabelSink> sink)
      : first_(extent.box.low[2]),
        sink_(std::move(sink)),
        scan_(slices, VoxelSelection::of_labels({extent.label}), options,
              [this, &placement](const GridPoint& p) { sink_->take(placement.position(p)); }) {}

  /// Takes part in the step at slice k - 1 of the grid, if its box reaches there.
  void step(std::size_t k) {
    if (k < first_ || done_) return;
    if (scan_.step()) return;
    done_ = true;
    sink_->finish(scan_.counts());
    sink_.reset();
  }

 private:
  std::size_t first_;
  bool done_ = false;
  std::unique_ptr<LabelSink> sink_;
  ObjectScan scan_;
};

/// The longest run of labels from the front that fits into memory; at least one.
std::size_t labels_that_fit(std::span<const LabelExtent> labels, const SamplingOptions& options) {
  std::size_t bytes = 0;
  std::size_t count = 0;
  for (const LabelExtent& extent : labels) {
    bytes += ObjectScan::memory_bytes(scan_options(options, extent));
    if (count > 0 && (bytes > kEachLabelMemory || count == kLabelsAtOnce)) break;
    ++count;
  }
  return count;
}

void walk(std::span<const LabelExtent> labels, const SamplingOptions& options, Sampling& sampling,
          const LabelSinkMaker& make_sink) {
  const std::size_t around = slices_around(scan_options(options, labels.front()));
  RecentSlices slices(sampling.grid(), around + 3);
  std::vector<std::unique_ptr<LabelWalk>> walks;
  for (const LabelExtent& extent : labels) {
    walks.push_back(std::make_unique<LabelWalk>(slices, extent, scan_options(options, extent),
                                                sampling.placement(), make_sink(extent.label)));
  }
  // A walk has a slice before its box, one behind, and a step that finds the end.
  for (std::size_t k = 0; k < sampling.grid().size()[2] + 3; ++k) {
    for (const auto& one : walks) one->step(k);
  }
}

}  // namespace

std::size_t sample_each_label(Volume& volume, const SamplingOptions& options,
                              const LabelSinkMaker& make_sink) {
  Sampling sampling(volume, options);
  const std::vector<LabelExtent> labels = find_labels(sampling.grid());
  if (labels.empty()) throw InputError("no label: every voxel is 0; check the file");
  std::span<const LabelExtent> left(labels);
  while (!left.empty()) {
    const std::size_t count = labels_that_fit(left, options);
    walk(left.first(count), options, sampling, make_sink);
    left = left.subspan(count);
  }
  return labels.size();
}

}  // namespace stream_recon
