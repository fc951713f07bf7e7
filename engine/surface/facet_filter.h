// Takes the facets of a window that satisfy a criterion on their two empty balls.
//
// Guarantees: each facet of the cloud is asked about once, by the window that emits it, with the
// same bits whatever the window: its points go in by rank. Thread rule: consume() from one thread
// at a time; it spreads the work itself and calls takes() from many.
#pragma once

#include "engine/interrupt.h"
#include "engine/surface/facet_sink.h"
#include "engine/windows/final_window.h"
#include "spatial/facet_balls.h"

namespace stream_recon {

class FacetFilter : public WindowConsumer {
 public:
  /// \pre `sink` and `stop` outlive the filter.
  FacetFilter(TriangleSource source, FacetSink& sink, const StopRequest& stop)
      : source_(source), sink_(sink), stop_(stop) {}

  void consume(const FinalWindow& window) override;

 protected:
  virtual bool takes(const FacetBalls& balls) const = 0;

 private:
  TriangleSource source_;
  FacetSink& sink_;
  const StopRequest& stop_;
};

}  // namespace stream_recon
