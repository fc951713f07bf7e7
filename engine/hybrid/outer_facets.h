// The facets of the surface beside holes: what patches must not have once more, and what edges they
// must not add to.
//
// Guarantees: a hole gets every facet of the surface, but its own, that has two of its samples or
// three; the file is a function of the facets and the holes alone. Thread rule: one caller; sorts
// on all threads. Memory, from the budget: an ExportReader; a sort of 16 bytes a facet and hole, or
// two fifths of what there is. Cost: one pass over the exported facets.
#pragma once

#include "engine/hybrid/hole_samples.h"
#include "engine/stage_context.h"

namespace stream_recon {

/// Name of the file of OuterFacet in the scratch directory.
inline constexpr const char* kOuterFacets = "hole_outer_facets";

/// \pre The exports under kLabelledPrefix have all facets but those of the holes.
/// \param beside gets the corners of these facets, which are the samples beside holes
/// \throw IoError, BudgetError, Interrupted
void store_outer_facets(const HoleSamples& samples, SampleChoice& beside,
                        const StageContext& context);

}  // namespace stream_recon
