#include "engine/power/power_window.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "engine/thread_clock.h"
#include "io/error.h"
#include "spatial/cell_view.h"
#include "spatial/circumball.h"
#include "spatial/vector.h"

namespace stream_recon {
namespace {

/// After the first conflict that a walk finds it goes on for so many tests, because what lies there
/// is likely to be missing for other cells as well.
constexpr std::uint64_t kTestsAfterConflict = 60;
/// So many tetrahedra that are not proved does a walk name at most.
constexpr std::uint64_t kMostUnproven = 24;
/// Of the cloud's poles so many are there from the start.
constexpr PoleNumber kSomePoles = 512;
/// Spheres are known well enough up to this share of the squared distance of samples, and what
/// touches a sample up to that share of it counts as touching it.
constexpr double kMostError = 1e-2;
constexpr double kTieError = 1e-3;
/// Samples whose distances are looked at.
constexpr VertexId kMostDistances = 4096;
/// Centres and radii of the stored poles, relative to the reach.
constexpr double kPoleRounding = 0x1p-50;

std::array<Point3, 4> corners(const CellView& cells, CellId cell) {
  const auto v = cells.vertices(cell);
  return {cells.point(v[0]), cells.point(v[1]), cells.point(v[2]), cells.point(v[3])};
}

Point3 outward_normal(const Point3& a, const Point3& b, const Point3& c) {
  return cross(minus(b, a), minus(c, a));
}

/// The middle one of the squared distances of owned samples from the next on the curve.
double typical_square(const FinalWindow& window) {
  const CellView cells = window.delaunay().view();
  const VertexId step = window.owned_count() / kMostDistances + 1;
  std::vector<double> squares;
  for (VertexId v = 0; v + 1 < window.owned_count(); v += step) {
    const Point3 d = minus(cells.point(v + 1), cells.point(v));
    squares.push_back(dot(d, d));
  }
  if (squares.empty()) return 0;
  const auto middle = squares.begin() + static_cast<std::ptrdiff_t>(squares.size() / 2);
  std::nth_element(squares.begin(), middle, squares.end());
  return *middle;
}

}  // namespace

void PowerCounts::add(const PowerCounts& other) {
  owned += other.owned;
  guests += other.guests;
  rounds += other.rounds;
  walks += other.walks;
  tests += other.tests;
  insert_seconds += other.insert_seconds;
  walk_seconds += other.walk_seconds;
  prove_seconds += other.prove_seconds;
}

/// What is closer than orthogonal to the sphere of a cell of the power diagram?
struct PowerWindow::Question {
  CellId cell;
  std::array<VertexId, 4> poles;
  bool is_infinite = false;
  std::optional<Orthosphere> sphere = std::nullopt;  ///< nothing: ask the exact predicate
  Point3 normal = {};  ///< of an infinite cell's hull facet, outward
};

PowerWindow::PowerWindow(CertifiedWindow& samples, const PoleIndex& index, PoleFinder& finder)
    : samples_(samples),
      poles_(samples, finder),
      some_step_(std::max<PoleNumber>(1, index.count() / kSomePoles)),
      reach_{.reach = index.reach(), .rounding = kPoleRounding},
      power_({.range = index.range()}) {}

PowerWindow::Outcome PowerWindow::build(const OwnedRange& owned, std::uint64_t memory_bytes) {
  memory_bytes_ = memory_bytes;
  const double square = typical_square(samples_.view());
  reach_.most_error = kMostError * square;
  tie_error_ = kTieError * square;
  poles_.add_owned(owned);
  poles_.add_some(some_step_);
  if (!close_owned()) return Outcome::kOutgrown;
  while (poles_.owned_count() != 0) {
    ++counts_.rounds;
    samples_.breathe();
    if (!insert_added()) return Outcome::kOutgrown;
    samples_.breathe();
    ask_all();
    if (!poles_.has_added() && unproven_.empty()) break;
    if (!prove()) return Outcome::kOutgrown;
  }
  counts_.owned = poles_.owned_count();
  counts_.guests = poles_.count() - counts_.owned;
  return Outcome::kDone;
}

// All samples that owned poles touch, before there is a triangulation: what walks will come by is
// nearly all proved then, and few have to be repeated.
bool PowerWindow::close_owned() {
  std::vector<std::pair<VertexId, CellId>> open;
  for (VertexId v = 0; v < poles_.owned_count(); ++v) {
    const CellId cell = poles_[v].cell;
    for (const VertexId sample : samples_.view().delaunay().view().vertices(cell)) {
      if (!close(sample, cell)) open.emplace_back(sample, cell);
    }
  }
  while (!unproven_.empty()) {
    samples_.breathe();
    if (!prove()) return false;
    std::erase_if(open, [this](const auto& at) { return close(at.first, at.second); });
  }
  return true;
}

bool PowerWindow::prove() {
  const ThreadClock clock(counts_.prove_seconds);
  const std::uint64_t others = bytes() - samples_.bytes();
  if (others >= memory_bytes_) return false;
  return samples_.prove(unproven_, memory_bytes_ - others) == Outcome::kDone;
}

std::uint64_t PowerWindow::bytes() const {
  return samples_.bytes() + power_.bytes() + poles_.bytes() + done_.capacity() / 8 +
         (closed_.capacity() + stamps_.capacity()) * sizeof(std::uint32_t) +
         (walk_.capacity() + unproven_.capacity()) * sizeof(CellId);
}

bool PowerWindow::insert_added() {
  const ThreadClock clock(counts_.insert_seconds);
  const std::vector<WeightedPoint3> sites = poles_.take_added();
  const std::uint64_t others = bytes() - power_.bytes() + sites.size() * sizeof(WeightedPoint3);
  if (others >= memory_bytes_) return false;
  power_.set_max_bytes(memory_bytes_ - others);
  const auto outcome = power_.insert(sites);
  if (outcome == RegularTriangulation::Outcome::kBadRange) {
    throw InputError("the balls of the cloud are too far apart in size for exact arithmetic; "
                     "use --surface solid, or leave far points out");
  }
  return outcome != RegularTriangulation::Outcome::kOutgrown;
}

void PowerWindow::ask_all() {
  const ThreadClock clock(counts_.walk_seconds);
  const WeightedCellView cells = power_.view();
  done_.resize(cells.slots());
  for (CellId cell = 0; cell < cells.slots(); ++cell) {
    if (!cells.is_live(cell) || done_[cell]) continue;
    const auto v = cells.vertices(cell);
    if (std::min(std::min(v[0], v[1]), std::min(v[2], v[3])) < poles_.owned_count()) ask(cell);
  }
}

// A final cell is never destroyed, so `done_` stays true of its slot.
void PowerWindow::ask(CellId cell) {
  const WeightedCellView cells = power_.view();
  Question question{.cell = cell, .poles = cells.vertices(cell)};
  const auto& v = question.poles;
  if (cells.is_infinite(cell)) {
    question.is_infinite = true;
    question.normal = outward_normal(cells.point(v[0]).point, cells.point(v[1]).point,
                                     cells.point(v[2]).point);
  } else {
    question.sphere = orthosphere(
        {cells.point(v[0]), cells.point(v[1]), cells.point(v[2]), cells.point(v[3])}, reach_);
    const bool may_tie = question.sphere && question.sphere->error < tie_error_;
    const auto sample = may_tie ? poles_.common_sample(v) : std::nullopt;
    if (sample) {
      const auto known = std::find_if(v.begin(), v.end(), [this](VertexId pole) {
        return poles_[pole].cell != SamplePoles::kNoCell;
      });
      done_[cell] = close(*sample, poles_[*known].cell) && closed_[*sample] <= counts_.rounds;
      return;
    }
  }
  walk(question);
}

void PowerWindow::begin_walk() {
  stamps_.resize(samples_.view().delaunay().view().slots());
  ++walk_number_;
  ++counts_.walks;
  walk_.clear();
}

/// Whether this walk comes by for the first time.
bool PowerWindow::visit(CellId cell) {
  if (stamps_[cell] == walk_number_) return false;
  stamps_[cell] = walk_number_;
  return true;
}

// What the walk has not come by yet beside the tetrahedra of `walk_` from `begin` on: all together,
// so that memory is fetched for many at a time.
void PowerWindow::find_neighbors(const CellView& cells, std::size_t begin) {
  neighbors_.clear();
  for (std::size_t i = begin; i < walk_.size(); ++i) {
    for (int side = 0; side < 4; ++side) {
      const CellId next = cells.neighbor(walk_[i], side);
      if (!visit(next)) continue;
      cells.prefetch(next);
      neighbors_.push_back(next);
    }
  }
  for (const CellId next : neighbors_) {
    if (!cells.is_infinite(next)) cells.prefetch_points(next);
  }
}

void PowerWindow::walk(const Question& question) {
  const CellView cells = samples_.view().delaunay().view();
  begin_walk();
  for (const VertexId pole : question.poles) {
    if (pole == RegularTriangulation::kInfinite) continue;
    const CellId start = poles_[pole].cell;
    if (start != SamplePoles::kNoCell && visit(start)) walk_.push_back(start);
  }
  std::uint64_t tests = 0;
  std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
  const std::size_t most_unproven = unproven_.size() + kMostUnproven;
  bool is_final = true;
  for (std::size_t begin = 0; begin < walk_.size() && tests < most;) {
    find_neighbors(cells, begin);
    begin = walk_.size();
    for (const CellId next : neighbors_) {
      ++tests;
      if (!samples_.is_final(next)) {
        is_final = false;
        unproven_.push_back(next);
        if (unproven_.size() >= most_unproven) most = 0;
        continue;
      }
      if (cells.is_infinite(next)) {
        if (is_seen(question, next)) walk_.push_back(next);
        continue;
      }
      if (!is_closer(question, cells, next)) continue;
      walk_.push_back(next);
      const SamplePoles::State state = poles_.state(next);
      if (state != SamplePoles::State::kMissing && state != SamplePoles::State::kAdded) continue;
      if (!power_.in_conflict(question.cell, poles_.site(next))) continue;
      poles_.add_missing(next);
      most = std::min(most, tests + kTestsAfterConflict);
      is_final = false;
    }
  }
  counts_.tests += tests;
  done_[question.cell] = is_final;
}

// Four poles that touch one sample have the sample for their sphere, and so have all poles that
// touch it: a tie that only roundings decide. They are brought all together, and no walk is needed
// for such cells then.
bool PowerWindow::close(VertexId sample, CellId start) {
  if (closed_.size() <= sample) closed_.resize(samples_.view().delaunay().vertex_count());
  if (closed_[sample] != 0) return true;
  const CellView cells = samples_.view().delaunay().view();
  const Orthosphere sphere{cells.point(sample), 0, tie_error_};
  begin_walk();
  visit(start);
  walk_.push_back(start);
  poles_.add_missing(start);
  bool is_closed = true;
  for (std::size_t begin = 0; begin < walk_.size();) {
    find_neighbors(cells, begin);
    begin = walk_.size();
    for (const CellId next : neighbors_) {
      if (!samples_.is_final(next)) {
        unproven_.push_back(next);
        is_closed = false;
        continue;
      }
      const auto v = cells.vertices(next);
      const bool touches = std::find(v.begin(), v.end(), sample) != v.end();
      if (!touches && (cells.is_infinite(next) || !may_conflict(corners(cells, next), sphere))) {
        continue;
      }
      walk_.push_back(next);
      if (!cells.is_infinite(next)) poles_.add_missing(next);
    }
  }
  if (is_closed) closed_[sample] = static_cast<std::uint32_t>(counts_.rounds) + 1;
  return is_closed;
}

bool PowerWindow::is_closer(const Question& question, const CellView& cells, CellId cell) {
  const std::array<Point3, 4> tetrahedron = corners(cells, cell);
  if (question.sphere) return may_conflict(tetrahedron, *question.sphere);
  const Circumball ball = circumball(tetrahedron);
  const double weight = dot(ball.centre, ball.centre) + tie_error_;
  return power_.in_conflict(question.cell, {plus(ball.origin, ball.centre), weight});
}

/// Whether the centre of the sphere lies beyond a hull facet of the samples.
bool PowerWindow::is_seen(const Question& question, CellId infinite) const {
  const CellView cells = samples_.view().delaunay().view();
  const auto v = cells.vertices(infinite);
  const Point3 a = cells.point(v[0]);
  const Point3 normal = outward_normal(a, cells.point(v[1]), cells.point(v[2]));
  if (question.is_infinite) return dot(normal, question.normal) > 0;
  return question.sphere && dot(normal, minus(question.sphere->centre, a)) > 0;
}

}  // namespace stream_recon
