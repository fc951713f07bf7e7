// The solid's facets: the candidates of all windows, once their tetrahedra have labels.
//
// Guarantees: a facet is one of the solid's iff its two tetrahedra lie on different sides, and
// faces the outer one; what is exported is a function of the cloud and the options alone, but for
// the windows it comes in. Thread rule: one caller; works on all threads that the memory allows.
// Memory: 5 to 7 MB a thread and a bit a border node of its window.
#pragma once

#include <cstdint>
#include <string_view>

#include "engine/labels/forest_merge.h"
#include "engine/stage_context.h"
#include "engine/surface/facet_export.h"
#include "engine/windows/export_reader.h"

namespace stream_recon {

struct FacetLabelCounts {
  std::uint64_t facets = 0;
  /// Samples whose two poles lie on the same side.
  std::uint64_t conflicts = 0;
};

struct FacetLabelOptions {
  SolidExportOptions exports;
  /// Facets beyond the gamma shape go to files of their own (records of FacetRecord) instead, named
  /// kFillsPrefix and the window's first rank.
  bool sets_fills_apart = false;
};

inline constexpr std::string_view kFillsPrefix = "fills_";
inline constexpr std::size_t kFillsBlock = std::size_t{128} << 10;

/// From what the windows exported to exports under kLabelledPrefix, of which there are none before.
/// \throw IoError, BudgetError, Interrupted
FacetLabelCounts label_facets(const ExportReader& windows, const WindowLabels& labels,
                              const FacetLabelOptions& options, const StageContext& context);

}  // namespace stream_recon
