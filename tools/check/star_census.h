// Counts vertices and edges from the stars of all vertices, and finds which labels are one.
//
// Thread rule: one thread. Memory: 200 bytes a triangle of the largest star; boundary rings.
#pragma once

#include "engine/order/external_sort.h"
#include "tools/check/component_census.h"
#include "tools/check/component_labels.h"
#include "tools/check/vertex_star.h"

namespace stream_recon {

/// Where the counts go.
struct StarCensusParts {
  const StageContext& context;
  ComponentLabels& labels;
  ComponentCensus& census;
  MeshFacts& facts;
};

/// \throw IoError, BudgetError, Interrupted
void count_stars(ExternalSort<StarRecord>& stars, const StarCensusParts& parts);

}  // namespace stream_recon
