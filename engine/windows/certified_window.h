// One window: the Delaunay tetrahedralization of a stretch of ranks and of as many guests as it
// takes to prove every star of the stretch final.
//
// Guarantees: after build() returned kDone, every cell with an owned vertex is a cell of the
// Delaunay tetrahedralization of the whole cloud: the certificate search found no point of the
// cloud in conflict with it. Such a cell is never destroyed again, so it is asked about once.
// Thread rule: one thread. Memory: what build() is told, about 500 bytes an owned point, besides
// fixed_memory(). Cost: about twice the triangulation of the owned points alone.
// Source: docs/algorithms/windows.md
#pragma once

#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

#include "engine/interrupt.h"
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

class CertifiedWindow {
 public:
  enum class Outcome {
    kDone,
    kOutgrown,  ///< the memory does not hold it: own fewer points
  };

  /// What a window holds whatever its size, bytes.
  static std::uint64_t fixed_memory(const CloudIndex& index);

  CertifiedWindow(const CloudIndex& index, IndexReader& reader, const StopRequest& stop)
      : index_(index),
        reader_(reader),
        stop_(stop),
        present_(index.leaf_count()),
        search_(index, reader) {}

  /// \param memory_bytes besides fixed_memory()
  /// \throw IoError, Interrupted
  Outcome build(const OwnedRange& owned, std::uint64_t memory_bytes);
  /// Gives the memory of build() back.
  void clear();

  /// \pre build() returned kDone
  FinalWindow view() const;
  /// Of the last build().
  const WindowCounts& counts() const { return counts_; }
  /// Held by the last build(), bytes.
  std::uint64_t bytes() const;

 private:
  struct OpenCell {
    VertexId lowest_vertex;
    CellId cell;
    friend bool operator<(const OpenCell& a, const OpenCell& b) {
      return std::tie(a.lowest_vertex, a.cell) < std::tie(b.lowest_vertex, b.cell);
    }
  };

  std::uint64_t bytes_beside() const;  ///< besides the Delaunay structure
  void add_owned();
  void add_guest(PointRank rank);
  void add_leaf(index_layout::LeafNumber leaf);
  void add_first_guests();
  bool insert_pending();
  std::vector<index_layout::LeafNumber> find_conflicts();
  void certify(std::span<OpenCell> open, std::vector<index_layout::LeafNumber>& leaves);

  const CloudIndex& index_;
  IndexReader& reader_;
  const StopRequest& stop_;
  PresentPoints present_;
  CertificateSearch search_;

  OwnedRange owned_;
  std::uint64_t memory_bytes_ = 0;
  Delaunay delaunay_;
  std::vector<Point3> pending_;  ///< to be inserted
  std::vector<PointRank> guest_ranks_;
  std::vector<std::uint64_t> input_indices_;
  std::vector<bool> is_certified_;  ///< by cell
  WindowCounts counts_;
};

}  // namespace stream_recon
