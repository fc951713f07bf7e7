// The tables of a run's page: every figure of the report.
//
// Thread rule: pure functions.
#pragma once

#include <string>

#include "engine/report.h"

namespace stream_recon::html {

bool has_surface(const Report& report);

/// Sections of HTML: surface, input and Delaunay structure, windows, resources.
std::string run_figures(const Report& report);

}  // namespace stream_recon::html
