// From the poles that windows handed on, and the labels, to the pole store.
//
// Guarantees: the store (poles/pole_store.h) is a function of the cloud alone: a tetrahedron that
// several windows found is there once, and so are tetrahedra of the very same ball, under the
// lowest name, with the largest angle, and the label of most of them, outside where there are as
// many. Thread rule: one caller; sorts on all threads. Memory: two sorts of 56 and 64 bytes a pole,
// or as much as there is. Scratch: two copies of the poles at most.
#pragma once

#include "engine/labels/forest_merge.h"
#include "engine/report.h"
#include "engine/stage_context.h"
#include "engine/windows/export_reader.h"

namespace stream_recon {

struct PoleSources {
  const ExportReader& windows;
  const WindowLabels& labels;
};

/// \param tolerance balls whose centres and radii are equal, rounded to multiples of it, are one;
/// 0:
///        those that are the very same; units of the input
/// \throw IoError, BudgetError, Interrupted
PoleReport store_poles(const PoleSources& sources, double tolerance, const StageContext& context);

}  // namespace stream_recon
