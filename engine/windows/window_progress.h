// Which windows are finished, and what they came to.
//
// Guarantees: the totals are those of the finished ranges, no more and no less, so that a run can
// go on from it. Thread rule: a value. Memory: the finished ranges, a few, since neighbours are
// joined.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/windows/certified_window.h"
#include "engine/windows/tetrahedra_census.h"

namespace stream_recon {

struct WindowTotals {
  std::uint64_t windows = 0;
  std::uint64_t splits = 0;  ///< windows that were begun too large
  WindowCounts counts;
  TetrahedraCensus tetrahedra;
  std::uint64_t export_files = 0;
  std::uint64_t export_records = 0;

  void add(const WindowTotals& part);
};

struct WindowProgress {
  WindowTotals totals;
  std::vector<OwnedRange> done;  ///< disjoint, ascending, no two touch

  /// Points in finished windows.
  std::uint64_t done_points() const;
  /// \pre Disjoint from those that are in.
  void add_range(const OwnedRange& range);
  /// The points that are in no finished window, ascending.
  std::vector<OwnedRange> open_ranges(std::uint64_t point_count) const;
};

}  // namespace stream_recon
