// The gamma surface as a filter of the facet stream (spatial/gamma_facet.h).
//
// Thread rule: as FacetFilter.
#pragma once

#include "engine/surface/facet_filter.h"
#include "spatial/gamma_facet.h"

namespace stream_recon {

class GammaFilter : public FacetFilter {
 public:
  /// \param delta_max_degrees in (0, 180]
  GammaFilter(double delta_max_degrees, const ChunkLayout& layout, const StopRequest& stop)
      : FacetFilter(TriangleSource::kGamma, layout, stop), criterion_(delta_max_degrees) {}

  void consume(const FinalWindow& window, ExportWriter& out) override {
    filter(window, criterion_, out);
  }

 private:
  GammaCriterion criterion_;
};

}  // namespace stream_recon
