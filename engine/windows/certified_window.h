// One window: the Delaunay tetrahedralization of a stretch of ranks and of as many guests as it
// takes to prove every star of the stretch final.
//
// Guarantees: after build() returned kDone, no point of the cloud is in conflict with a cell that
// the window emits or a facet of which it emits, and no point later on the curve with another cell
// that has an owned vertex, or no point at all where whole stars are asked for. That is what
// FinalWindow promises (docs/algorithms/windows.md). Thread rule: one thread. Memory: what build()
// is told, about 500 bytes an owned point, besides fixed_memory(). Cost: about twice the
// triangulation of the owned points alone. Source: docs/algorithms/windows.md
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/stage_context.h"
#include "engine/windows/certificate_search.h"
#include "engine/windows/final_window.h"
#include "engine/windows/guest_sample.h"

namespace stream_recon {

struct WindowCounts {
  std::uint64_t guests = 0;
  std::uint64_t rounds = 0;
  SearchCounts search;
  double insert_seconds = 0;  ///< of one thread
  double search_seconds = 0;

  void add(const WindowCounts& other);
};

struct CertifiedWindowOptions {
  /// Prove all cells with an owned vertex, not only what is emitted.
  bool whole_stars = false;
};

class CertifiedWindow {
 public:
  enum class Outcome {
    kDone,
    kOutgrown,  ///< the memory does not hold it: own fewer points
  };

  /// What a window holds whatever its size, bytes.
  static std::uint64_t fixed_memory(const CloudIndex& index);

  CertifiedWindow(const CloudIndex& index, IndexReader& reader, const StageContext& context,
                  const CertifiedWindowOptions& options)
      : index_(index),
        reader_(reader),
        context_(context),
        options_(options),
        present_(index.leaf_count()),
        search_(index, reader) {}

  /// \param memory_bytes besides fixed_memory()
  /// \throw IoError, Interrupted
  Outcome build(const OwnedRange& owned, std::uint64_t memory_bytes);
  /// One round more, for cells without an owned vertex: asks about them, and inserts the points in
  /// conflict with some. The others are final from now on, as those with an owned vertex are after
  /// a build() that asked for whole stars; final cells stay as long as the window. \param
  /// memory_bytes as of build() \throw IoError, Interrupted
  Outcome prove(std::vector<CellId>& cells, std::uint64_t memory_bytes);
  /// \pre whole stars; build() returned kDone
  bool is_final(CellId cell) const { return cell < final_.size() && final_[cell]; }
  /// Lets the run be stopped, and its progress be shown, in the midst of a window.
  void breathe() const {
    context_.stop.check();
    context_.progress.advance(0);
  }
  /// Gives the memory of build() back.
  void clear();

  /// \pre build() returned kDone
  FinalWindow view() const;
  /// Of the last build().
  const WindowCounts& counts() const { return counts_; }
  /// Held by the last build(), bytes.
  std::uint64_t bytes() const;

 private:
  /// Cells to be asked about together, and from which leaf of the cloud on.
  struct OpenCells {
    index_layout::LeafNumber first_leaf = 0;
    std::vector<CellId> cells;
  };

  std::uint64_t bytes_beside() const;  ///< besides the Delaunay structure
  void add_owned();
  void add_guest(PointRank rank);
  void add_leaf(index_layout::LeafNumber leaf);
  void add_first_guests();
  bool insert_pending();
  std::vector<index_layout::LeafNumber> find_conflicts();
  void ask(OpenCells& open, std::vector<index_layout::LeafNumber>& leaves);
  void note_final();

  const CloudIndex& index_;
  IndexReader& reader_;
  const StageContext& context_;
  const CertifiedWindowOptions options_;
  PresentPoints present_;
  CertificateSearch search_;

  OwnedRange owned_;
  std::uint64_t memory_bytes_ = 0;
  Delaunay delaunay_;
  std::vector<Point3> pending_;  ///< to be inserted
  std::vector<PointRank> guest_ranks_;
  std::vector<std::uint64_t> input_indices_;
  VertexId asked_ = 0;  ///< vertices when cells were last asked about
  std::vector<bool> final_;
  WindowCounts counts_;
};

}  // namespace stream_recon
