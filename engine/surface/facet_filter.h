// Takes the facets of a window that satisfy a criterion on their two empty balls.
//
// Guarantees: each facet of the cloud is asked about once, by the window that emits it, with the
// same bits whatever the window: its points go in by rank. Most facets are decided on estimates
// that the facets of a tetrahedron share; the rest, and the angles of the taken ones, on the
// accurate balls, so that estimates save time and change nothing.
// Thread rule: consume() from many threads at once, each with its own window; it works in one.
// Memory: about 350 KB a call.
// Cost: about 70 ns a tetrahedron and 200 ns a taken facet.
#pragma once

#include "engine/interrupt.h"
#include "engine/surface/facet_export.h"
#include "engine/windows/final_window.h"

namespace stream_recon {

class FacetFilter : public WindowConsumer {
 public:
  /// \pre `stop` outlives the filter.
  FacetFilter(TriangleSource source, const ChunkLayout& layout, const StopRequest& stop)
      : source_(source), layout_(layout), stop_(stop) {}

 protected:
  /// Made for GammaCriterion and AlphaCriterion.
  template <class Criterion>
  void filter(const FinalWindow& window, const Criterion& criterion, ExportWriter& out);

 private:
  TriangleSource source_;
  ChunkLayout layout_;
  const StopRequest& stop_;
};

}  // namespace stream_recon
