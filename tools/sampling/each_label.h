// Every label of a volume as a cloud of its own.
//
// Labels are walked side by side, so that the volume is read once for as many of them as fit into
// kEachLabelMemory. Thread rule: one user.
#pragma once

#include <functional>

#include "tools/sampling/label_table.h"
#include "tools/sampling/sampling.h"

namespace stream_recon {

inline constexpr std::size_t kEachLabelMemory = std::size_t{64} << 20;  ///< bytes, besides slices
inline constexpr std::size_t kLabelsAtOnce = 128;                       ///< files held open

/// What becomes of one label's points.
class LabelSink {
 public:
  virtual ~LabelSink() = default;
  virtual void take(const Point3& point) = 0;
  virtual void finish(const SampleCounts& counts) = 0;
};

using LabelSinkMaker = std::function<std::unique_ptr<LabelSink>(double label)>;

/// Walks all labels but 0; \pre options.kind is not kCrossings. Returns the number of labels.
/// \throw InputError no label, or no label volume; what the volume and the sinks throw
std::size_t sample_each_label(Volume& volume, const SamplingOptions& options,
                              const LabelSinkMaker& make_sink);

}  // namespace stream_recon
