// Charts of a run as inline SVG that takes its colours from the page.
//
// Each is one <svg> that is as wide as its place. Thread rule: pure functions.
#pragma once

#include <string>

#include "engine/report.h"

namespace stream_recon::html {

/// Resident memory against time, with the stages behind it, and the budget where it is near.
std::string memory_chart(const Report& report);

/// How many triangles have which angle Delta, degree by degree, in the colours of the pictures.
std::string delta_chart(const DeltaHistogram& histogram);

}  // namespace stream_recon::html
