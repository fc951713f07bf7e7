// What windows find out about inside and outside: each makes the signed forest of its evidence and
// hands on what only others can decide.
//
// Exports of a window, under its first rank as chunk: its border nodes, the contracted edges
// between them, and the facets and pole pairs whose two cells are not known to lie on the same side
// (facets) or on opposite sides (poles); where asked for, all poles with their balls.
// Thread rule: consume() from many threads at once, each with its own window. Memory: memory(),
// about 330 bytes an owned point. Cost: about 8 us an owned point, 1 more with poles.
#pragma once

#include <cstdint>
#include <limits>

#include "engine/interrupt.h"
#include "engine/spacing/spacing_reader.h"
#include "engine/windows/final_window.h"

namespace stream_recon {

struct EvidenceOptions {
  bool hands_on_poles = false;  ///< for poles/pole_stage.h
  /// Points from this input index on are no samples (order/far_points.h): they have no poles, and
  /// say nothing about the spacing.
  std::uint64_t samples = std::numeric_limits<std::uint64_t>::max();
  /// Balls are no poles where their radius is less than so many spacings of their samples.
  double least_ball = 0;
};

class EvidenceCollector : public WindowConsumer {
 public:
  /// For the plan of the windows, bytes.
  static constexpr std::uint64_t kBytesAnOwnedPoint = 330;

  /// \pre Both others outlive the collector.
  EvidenceCollector(SpacingCache& spacings, const StopRequest& stop, const EvidenceOptions& options)
      : spacings_(spacings), stop_(stop), options_(options) {}

  /// \pre Whole stars are final; fewer than 2^32 - 1 points.
  void consume(const FinalWindow& window, ExportWriter& out) override;
  std::uint64_t memory(const FinalWindow& window) const override;

 private:
  SpacingCache& spacings_;
  const StopRequest& stop_;
  EvidenceOptions options_;
};

}  // namespace stream_recon
