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
/// Cells asked about at a time.
constexpr std::size_t kAskedTogether = 16;
/// Spheres are known well enough up to this share of the squared distance of samples, and what
/// touches a sample up to that share of it counts as touching it.
constexpr double kMostError = 1e-2;
constexpr double kTieError = 1e-3;
/// Samples whose distances are looked at.
constexpr VertexId kMostDistances = 4096;
/// Centres and radii of the stored poles, relative to the reach.
constexpr double kPoleRounding = 0x1p-50;

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
  seconds.add(other.seconds);
}

/// What is closer than orthogonal to the sphere of a cell of the power diagram?
struct PowerWindow::Question {
  static constexpr CellId kNone = SamplePoles::kNoCell;

  CellId cell = kNone;
  std::array<CellId, 4> starts{kNone, kNone, kNone, kNone};  ///< tetrahedra of its poles
  std::optional<VertexId> sample = std::nullopt;             ///< that all four touch
  bool is_infinite = false;
  std::optional<Orthosphere> sphere = std::nullopt;  ///< nothing: ask the exact predicate
  Point3 normal = {};                                ///< of an infinite cell's hull facet, outward
};

PowerWindow::PowerWindow(CertifiedWindow& samples, const PoleIndex& index, PoleFinder& finder)
    : samples_(samples),
      poles_(samples, finder),
      walk_(std::in_place, samples),
      some_(index.some()),
      reach_{.reach = index.reach(), .rounding = kPoleRounding},
      power_({.range = index.range()}) {}

PowerWindow::Outcome PowerWindow::build(const OwnedRange& owned, std::uint64_t memory_bytes,
                                        const SampleChoice* choice) {
  memory_bytes_ = memory_bytes;
  const double square = typical_square(samples_.view());
  reach_.most_error = kMostError * square;
  tie_error_ = kTieError * square;
  {
    const ThreadClock clock(counts_.seconds.touching);
    poles_.add_owned(owned, choice);
  }
  poles_.add_some(some_);
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
  {
    const ThreadClock clock(counts_.seconds.touching);
    for (VertexId v = 0; v < poles_.owned_count(); ++v) {
      const CellId cell = poles_[v].cell;
      for (const VertexId sample : samples_.view().delaunay().view().vertices(cell)) {
        if (!close(sample, cell)) open.emplace_back(sample, cell);
      }
    }
  }
  while (!unproven_.empty()) {
    samples_.breathe();
    if (!prove()) return false;
    const ThreadClock clock(counts_.seconds.touching);
    std::erase_if(open, [this](const auto& at) { return close(at.first, at.second); });
  }
  return true;
}

bool PowerWindow::prove() {
  const ThreadClock clock(counts_.seconds.prove);
  const std::uint64_t others = bytes() - samples_.bytes();
  if (others >= memory_bytes_) return false;
  return samples_.prove(unproven_, memory_bytes_ - others) == Outcome::kDone;
}

std::uint64_t PowerWindow::bytes() const {
  return samples_.bytes() + power_.bytes() + poles_.bytes() + done_.capacity() / 8 +
         (walk_ ? walk_->bytes() : 0) + closed_.capacity() * sizeof(std::uint32_t) +
         unproven_.capacity() * sizeof(CellId);
}

bool PowerWindow::insert_added() {
  const ThreadClock clock(counts_.seconds.insert);
  const std::vector<WeightedPoint3> sites = poles_.take_added();
  const std::uint64_t others = bytes() - power_.bytes() + sites.size() * sizeof(WeightedPoint3);
  if (others >= memory_bytes_) return false;
  power_.set_max_bytes(memory_bytes_ - others);
  const auto outcome = power_.insert(sites);
  if (outcome == RegularTriangulation::Outcome::kBadRange) {
    throw InputError(
        "the balls of the cloud are too far apart in size for exact arithmetic; "
        "use --surface solid, or leave far points out");
  }
  return outcome != RegularTriangulation::Outcome::kOutgrown;
}

void PowerWindow::ask_all() {
  const ThreadClock clock(counts_.seconds.walk);
  const WeightedCellView cells = power_.view();
  done_.resize(cells.slots());
  std::array<CellId, kAskedTogether> some;
  std::size_t count = 0;
  for (CellId cell = 0; cell < cells.slots(); ++cell) {
    if (!cells.is_live(cell) || done_[cell]) continue;
    const auto v = cells.vertices(cell);
    if (std::min(std::min(v[0], v[1]), std::min(v[2], v[3])) >= poles_.owned_count()) continue;
    cells.prefetch_points(cell);
    for (const VertexId pole : v) {
      if (pole != RegularTriangulation::kInfinite) poles_.prefetch(pole);
    }
    some[count++] = cell;
    if (count == some.size()) ask(some), count = 0;
  }
  ask(std::span(some).first(count));
}

// Several at once, so that the memory that one needs is fetched while others are dealt with.
void PowerWindow::ask(std::span<const CellId> cells) {
  const CellView samples = samples_.view().delaunay().view();
  std::array<Question, kAskedTogether> questions;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    questions[i] = question(cells[i]);
    for (const CellId start : questions[i].starts) {
      if (start != SamplePoles::kNoCell) samples.prefetch(start);
    }
  }
  for (std::size_t i = 0; i < cells.size(); ++i) {
    for (const CellId start : questions[i].starts) {
      if (start == SamplePoles::kNoCell) continue;
      for (int side = 0; side < 4; ++side) walk_->prefetch(samples.neighbor(start, side));
    }
  }
  for (std::size_t i = 0; i < cells.size(); ++i) answer(questions[i]);
}

PowerWindow::Question PowerWindow::question(CellId cell) const {
  const WeightedCellView cells = power_.view();
  Question question{.cell = cell};
  const auto v = cells.vertices(cell);
  for (int i = 0; i < 4; ++i) {
    if (v[i] != RegularTriangulation::kInfinite) question.starts[i] = poles_[v[i]].cell;
  }
  if (cells.is_infinite(cell)) {
    question.is_infinite = true;
    question.normal =
        outward_normal(cells.point(v[0]).point, cells.point(v[1]).point, cells.point(v[2]).point);
    return question;
  }
  question.sphere = orthosphere(cells.corners(cell), reach_);
  const bool may_tie = question.sphere && question.sphere->error < tie_error_;
  if (may_tie) question.sample = poles_.common_sample(v);
  return question;
}

// A final cell is never destroyed, so `done_` stays true of its slot.
void PowerWindow::answer(const Question& question) {
  if (!question.sample) {
    walk(question);
    return;
  }
  const auto known = std::find_if(question.starts.begin(), question.starts.end(),
                                  [](CellId start) { return start != SamplePoles::kNoCell; });
  done_[question.cell] =
      close(*question.sample, *known) && closed_[*question.sample] <= counts_.rounds;
}

void PowerWindow::walk(const Question& question) {
  walk_->begin();
  ++counts_.walks;
  if (question.sphere) walk_->aim(*question.sphere);
  for (const CellId start : question.starts) {
    if (start != SamplePoles::kNoCell && walk_->visit(start)) walk_->add(start);
  }
  std::uint64_t tests = 0;
  std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
  const std::size_t most_unproven = unproven_.size() + kMostUnproven;
  bool is_final = true;
  while (tests < most) {
    const std::vector<CellId>& neighbors = walk_->step();
    if (neighbors.empty()) break;
    for (const CellId next : neighbors) {
      if (!walk_->visit(next)) continue;
      ++tests;
      const BallWalk::Kind kind = walk_->kind(next);
      if (kind == BallWalk::Kind::kNotFinal) {
        is_final = false;
        unproven_.push_back(next);
        if (unproven_.size() >= most_unproven) most = 0;
        continue;
      }
      if (kind == BallWalk::Kind::kInfinite) {
        if (is_seen(question, next)) walk_->add(next);
        continue;
      }
      if (!is_closer(question, next)) continue;
      walk_->add(next);
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
  walk_->begin();
  ++counts_.walks;
  walk_->aim({cells.point(sample), 0, tie_error_});
  walk_->visit(start);
  walk_->add(start);
  poles_.add_missing(start);
  bool is_closed = true;
  for (;;) {
    const std::vector<CellId>& neighbors = walk_->step();
    if (neighbors.empty()) break;
    for (const CellId next : neighbors) {
      if (!walk_->visit(next)) continue;
      const BallWalk::Kind kind = walk_->kind(next);
      if (kind == BallWalk::Kind::kNotFinal) {
        unproven_.push_back(next);
        is_closed = false;
        continue;
      }
      if (kind == BallWalk::Kind::kInfinite) {
        const auto v = cells.vertices(next);
        if (std::find(v.begin(), v.end(), sample) != v.end()) walk_->add(next);
      } else if (walk_->in_conflict(next)) {
        walk_->add(next);
        poles_.add_missing(next);
      }
    }
  }
  if (is_closed) closed_[sample] = static_cast<std::uint32_t>(counts_.rounds) + 1;
  return is_closed;
}

bool PowerWindow::is_closer(const Question& question, CellId cell) {
  if (question.sphere) return walk_->in_conflict(cell);
  const Circumball ball = circumball(samples_.view().delaunay().view().corners(cell));
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
