// The alpha surface as a filter of the facet stream (spatial/alpha_facet.h).
//
// Thread rule: as FacetFilter.
#pragma once

#include "engine/surface/facet_filter.h"
#include "spatial/alpha_facet.h"

namespace stream_recon {

class AlphaFilter : public FacetFilter {
 public:
  /// \param alpha radius > 0, units of the input
  AlphaFilter(double alpha, const ChunkLayout& layout, const StopRequest& stop)
      : FacetFilter(TriangleSource::kAlpha, layout, stop), criterion_(alpha) {}

  void consume(const FinalWindow& window, ExportWriter& out) override {
    filter(window, criterion_, out);
  }

 private:
  AlphaCriterion criterion_;
};

}  // namespace stream_recon
