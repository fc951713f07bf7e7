// From what the windows have handed on of evidence to labels: the forest of the whole cloud, on
// disk.
//
// Guarantees: labels are those of the signed maximum spanning forest of all evidence, however the
// cloud was cut into windows and whatever the memory (proof: docs/algorithms/labels.md).
// Consecutive windows are joined in groups, a thread each or as large as the memory holds, those
// groups again, until one is the whole; from there labels go down. Thread rule: one caller; joins
// on all threads that the memory allows; then const access from many. Memory: all that two
// neighbours need, at most all there is: 8.25 bytes a border node of those joined and 0.7 MB each;
// afterwards 40 bytes a window. Scratch: at most two levels of joined parts, and 4 bytes a node of
// every table.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/labels/label_file.h"
#include "engine/stage_context.h"
#include "engine/windows/export_reader.h"
#include "engine/windows/final_window.h"

namespace stream_recon {

struct ForestCounts {
  std::uint64_t nodes = 0;       ///< that windows handed on, each once
  std::uint64_t edges = 0;       ///< that windows handed on
  std::uint64_t levels = 0;      ///< of joining
  std::uint64_t unattached = 0;  ///< in the windows' tables, as often as they are there
};

/// The labels of the nodes that windows handed on.
class WindowLabels {
 public:
  WindowLabels() = default;
  /// \param first_ranks of the windows, ascending \param labels a table a window
  WindowLabels(std::vector<PointRank> first_ranks, std::unique_ptr<const LabelFile> labels,
               Reservation memory);

  /// Of the window that begins at this rank, by position in its table; none of a window that handed
  /// on nothing. \throw IoError, BudgetError
  NodeLabels labels(PointRank first_rank) const;

 private:
  std::vector<PointRank> first_ranks_;
  std::unique_ptr<const LabelFile> labels_;
  Reservation memory_;
};

struct MergedForest {
  WindowLabels labels;
  ForestCounts counts;
};

/// \throw IoError, Interrupted; BudgetError two neighbours do not fit
MergedForest merge_forest(const ExportReader& exports, const StageContext& context);

}  // namespace stream_recon
