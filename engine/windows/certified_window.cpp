#include "engine/windows/certified_window.h"

#include <algorithm>
#include <array>

#include "engine/thread_clock.h"
#include "engine/windows/final_simplices.h"
#include "spatial/cell_view.h"

namespace stream_recon {
namespace {

using namespace index_layout;

/// Of how many finite cells the first round asks about one. Most that are in conflict then die of
/// what their neighbours name; what is left is asked about in the second.
constexpr CellId kFirstRoundShare = 8;

void sort_unique(std::vector<LeafNumber>& leaves) {
  std::sort(leaves.begin(), leaves.end());
  leaves.erase(std::unique(leaves.begin(), leaves.end()), leaves.end());
}

}  // namespace

void WindowCounts::add(const WindowCounts& other) {
  guests += other.guests;
  rounds += other.rounds;
  search.add(other.search);
  insert_seconds += other.insert_seconds;
  search_seconds += other.search_seconds;
}

std::uint64_t CertifiedWindow::fixed_memory(const CloudIndex& index) {
  return IndexReader::kMemory + PresentPoints::memory(index.leaf_count()) +
         CertificateSearch::memory(index) + (std::uint64_t{1} << 20);
}

CertifiedWindow::Outcome CertifiedWindow::build(const OwnedRange& owned,
                                                std::uint64_t memory_bytes) {
  clear();
  owned_ = owned;
  memory_bytes_ = memory_bytes;
  delaunay_ = Delaunay({.max_bytes = memory_bytes, .range = index_.range});
  add_owned();
  add_first_guests();
  for (;;) {
    ++counts_.rounds;
    breathe();
    if (!insert_pending()) return Outcome::kOutgrown;
    breathe();
    const std::vector<LeafNumber> leaves = find_conflicts();
    if (leaves.empty() && counts_.rounds > 1) break;
    for (const LeafNumber leaf : leaves) add_leaf(leaf);
  }
  counts_.guests = guest_ranks_.size();
  if (options_.whole_stars) note_final();
  return Outcome::kDone;
}

void CertifiedWindow::note_final() {
  const FinalWindow window = view();
  const CellView cells = delaunay_.view();
  final_.assign(cells.slots(), false);
  for (CellId cell = 0; cell < cells.slots(); ++cell) {
    if (cells.is_live(cell) && has_owned(window, cells.vertices(cell))) final_[cell] = true;
  }
}

CertifiedWindow::Outcome CertifiedWindow::prove(std::vector<CellId>& cells,
                                                std::uint64_t memory_bytes) {
  memory_bytes_ = memory_bytes;
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  std::vector<LeafNumber> leaves;
  {
    const ThreadClock clock(counts_.search_seconds);
    final_.resize(delaunay_.view().slots());
    for (std::size_t first = 0; first < cells.size(); first += CertificateSearch::kMostCells) {
      const std::size_t count = std::min(CertificateSearch::kMostCells, cells.size() - first);
      const std::span<const CellId> some(&cells[first], count);
      std::array<LeafNumber, CertificateSearch::kMostCells> conflicts;
      breathe();
      search_.search(delaunay_, {present_, 0}, some, conflicts);
      for (std::size_t i = 0; i < count; ++i) {
        if (conflicts[i] != CertificateSearch::kFinal) leaves.push_back(conflicts[i]);
        final_[some[i]] = conflicts[i] == CertificateSearch::kFinal;
      }
    }
    sort_unique(leaves);
    counts_.search.add(search_.take_counts());
  }
  cells.clear();
  for (const LeafNumber leaf : leaves) add_leaf(leaf);
  ++counts_.rounds;
  counts_.guests = guest_ranks_.size();
  return insert_pending() ? Outcome::kDone : Outcome::kOutgrown;
}

void CertifiedWindow::clear() {
  delaunay_ = Delaunay();
  present_.clear();
  pending_ = {};
  guest_ranks_ = {};
  input_indices_ = {};
  asked_ = 0;
  final_ = {};
  counts_ = {};
  search_.take_counts();
}

std::uint64_t CertifiedWindow::bytes() const {
  return delaunay_.bytes() + bytes_beside();
}

std::uint64_t CertifiedWindow::bytes_beside() const {
  return pending_.capacity() * sizeof(Point3) + guest_ranks_.capacity() * sizeof(PointRank) +
         input_indices_.capacity() * sizeof(std::uint64_t) + final_.capacity() / 8;
}

void CertifiedWindow::add_owned() {
  pending_.reserve(owned_.count);
  input_indices_.reserve(owned_.count + owned_.count / 2);
  for (PointRank rank = owned_.first; rank < owned_.end(); ++rank) {
    const StoredPoint stored = reader_.point(rank);
    pending_.push_back(stored.point);
    input_indices_.push_back(stored.input_index);
  }
  const LeafNumber end = quotient_up(owned_.end(), kLeafPoints);
  for (LeafNumber leaf = leaf_of(owned_.first); leaf < end; ++leaf) present_.add_leaf(leaf);
}

void CertifiedWindow::add_guest(PointRank rank) {
  const StoredPoint stored = reader_.point(rank);
  pending_.push_back(stored.point);
  input_indices_.push_back(stored.input_index);
  guest_ranks_.push_back(rank);
}

void CertifiedWindow::add_leaf(LeafNumber leaf) {
  if (!present_.add_leaf(leaf)) return;
  const PointRank end = std::min((leaf + 1) * kLeafPoints, index_.point_count);
  for (PointRank rank = leaf * kLeafPoints; rank < end; ++rank) {
    if (!present_.is_single(rank)) add_guest(rank);
  }
}

void CertifiedWindow::add_first_guests() {
  GuestSample sample = sample_guests(index_, reader_, owned_, GuestSampleOptions{});
  for (const LeafNumber leaf : sample.leaves) add_leaf(leaf);
  sample.singles.insert(sample.singles.end(), index_.simplex.begin(), index_.simplex.end());
  std::sort(sample.singles.begin(), sample.singles.end());
  for (const PointRank rank : sample.singles) {
    if (present_.add_single(rank)) add_guest(rank);
  }
}

bool CertifiedWindow::insert_pending() {
  const ThreadClock clock(counts_.insert_seconds);
  const std::uint64_t beside = bytes_beside();
  if (beside >= memory_bytes_) return false;
  delaunay_.set_max_bytes(memory_bytes_ - beside);
  if (delaunay_.insert(pending_) != Delaunay::Outcome::kDone) return false;
  pending_.clear();
  return bytes() <= memory_bytes_;
}

// The leaves of conflicts with cells not yet asked about, ascending. A cell that has no new vertex
// was there the last time; had a conflict been found then, it would be gone.
std::vector<LeafNumber> CertifiedWindow::find_conflicts() {
  const ThreadClock clock(counts_.search_seconds);
  const FinalWindow window = view();
  const CellView cells = delaunay_.view();
  std::vector<LeafNumber> leaves;
  OpenCells emitted{0, {}};
  OpenCells others{leaf_of(owned_.first), {}};
  for (CellId cell = 0; cell < cells.slots(); ++cell) {
    if (!cells.is_live(cell)) continue;
    const bool is_infinite = cells.is_infinite(cell);
    const bool waits = is_infinite || cell % kFirstRoundShare != 0;
    if (waits && counts_.rounds == 1) continue;
    const auto v = cells.vertices(cell);
    const VertexId lowest = std::min(std::min(v[0], v[1]), std::min(v[2], v[3]));
    if (lowest >= owned_.count) continue;
    const VertexId newest =
        std::max(std::max(v[0], v[1]), is_infinite ? v[2] : std::max(v[2], v[3]));
    const bool has_waited = waits && counts_.rounds == 2;
    if (newest < asked_ && !has_waited) continue;
    const bool asks_all = options_.whole_stars || emits_part(window, v);
    OpenCells& open = asks_all ? emitted : others;
    open.cells.push_back(cell);
    if (open.cells.size() == CertificateSearch::kMostCells) ask(open, leaves);
  }
  ask(emitted, leaves);
  ask(others, leaves);
  asked_ = owned_.count + guest_ranks_.size();
  sort_unique(leaves);
  counts_.search.add(search_.take_counts());
  return leaves;
}

void CertifiedWindow::ask(OpenCells& open, std::vector<LeafNumber>& leaves) {
  breathe();
  std::array<LeafNumber, CertificateSearch::kMostCells> conflicts;
  search_.search(delaunay_, {present_, open.first_leaf}, open.cells, conflicts);
  for (std::size_t i = 0; i < open.cells.size(); ++i) {
    if (conflicts[i] != CertificateSearch::kFinal) leaves.push_back(conflicts[i]);
  }
  open.cells.clear();
  // Many cells name the same leaf: the list is made short before it grows.
  if (leaves.capacity() - leaves.size() < CertificateSearch::kMostCells) sort_unique(leaves);
}

FinalWindow CertifiedWindow::view() const {
  return FinalWindow({.delaunay = &delaunay_,
                      .first_rank = owned_.first,
                      .owned_count = owned_.count,
                      .guest_ranks = guest_ranks_,
                      .input_indices = input_indices_});
}

}  // namespace stream_recon
