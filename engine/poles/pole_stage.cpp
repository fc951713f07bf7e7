#include "engine/poles/pole_stage.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "engine/order/external_sort.h"
#include "engine/poles/pole_records.h"
#include "engine/poles/pole_store.h"
#include "engine/windows/export_cursor.h"

namespace stream_recon {
namespace {

constexpr std::size_t kBatch = 1 << 10;

/// Reading both lists of a window at once.
constexpr std::uint64_t kReading =
    2 * export_cursor_memory() + kBatch * (sizeof(PoleName) + sizeof(PoleBall));

/// The tetrahedra of one ball, which come one after the other.
class Coincidence {
 public:
  explicit Coincidence(const PoleByBall& lowest)
      : lowest_(lowest), pole_(lowest.pole), last_(lowest.pole.tetrahedron) {
    vote(lowest.pole);
  }

  bool takes(const PoleByBall& other) const { return other.has_ball_of(lowest_); }
  /// \pre takes(other), and it comes later in the order
  void add(const Pole& other) {
    if (other.tetrahedron == last_) return;  // another window found it too
    last_ = other.tetrahedron;
    pole_.separation = std::max(pole_.separation, other.separation);
    vote(other);
  }

  Pole merged() const {
    Pole pole = pole_;
    pole.is_inside = inside_ > outside_ ? 1 : 0;
    return pole;
  }
  std::uint64_t tetrahedra() const { return inside_ + outside_; }
  bool is_conflict() const { return inside_ != 0 && outside_ != 0; }

 private:
  void vote(const Pole& pole) { ++(pole.is_inside != 0 ? inside_ : outside_); }

  PoleByBall lowest_;
  Pole pole_;
  NodeKey last_;
  std::uint64_t inside_ = 0;
  std::uint64_t outside_ = 0;
};

class PoleStage {
 public:
  PoleStage(const ExportReader& windows, const WindowLabels& labels, double tolerance,
            const StageContext& context)
      : windows_(windows),
        labels_(labels),
        tolerance_(tolerance),
        context_(context),
        first_ranks_(windows.chunks(ExportKind::kPoleNames)) {}

  PoleReport run() {
    context_.progress.begin_stage("poles", first_ranks_.size(), "windows");
    const std::uint64_t bytes = sort_bytes();
    ExternalSort<PoleByName> by_name(context_, {"poles_by_name", bytes});
    {
      ExternalSort<PoleByBall> by_ball(context_, {"poles_by_ball", bytes});
      gather(by_ball);
      merge(by_ball, by_name);
    }
    write(by_name);
    context_.progress.end_stage();
    return counts_;
  }

 private:
  /// For each of the two sorts: what holds all poles, or half of what there is.
  std::uint64_t sort_bytes() const {
    constexpr std::uint64_t kLeast = ExternalSort<PoleByName>::least_memory();
    std::uint64_t poles = 0;
    std::uint64_t nodes = 0;
    for (const PointRank rank : first_ranks_) {
      poles += windows_.count(ExportKind::kPoleNames, rank);
      nodes = std::max(nodes, windows_.count(ExportKind::kEvidenceNodes, rank));
    }
    // A fourth of a sort's memory may go to packing.
    const std::uint64_t whole = poles * sizeof(PoleByBall) / 3 * 4 + kLeast;
    const std::uint64_t others = kReading + NodeLabels::memory(nodes) + LabelFile::reading_memory();
    const std::uint64_t available = context_.budget.available();
    return std::clamp((available - std::min(available, others)) / 2, kLeast, whole);
  }

  void gather(ExternalSort<PoleByBall>& by_ball) {
    const Reservation memory = context_.budget.reserve(kReading, "the windows' poles");
    std::vector<PoleName> names(kBatch);
    std::vector<PoleBall> balls(kBatch);
    for (const PointRank rank : first_ranks_) {
      context_.stop.check();
      const NodeLabels labels = labels_.labels(rank);
      ExportCursor<PoleName> name_cursor(windows_, ExportKind::kPoleNames, rank);
      ExportCursor<PoleBall> ball_cursor(windows_, ExportKind::kPoleBalls, rank);
      while (const std::size_t count = name_cursor.read(std::span(names))) {
        if (ball_cursor.read(std::span(balls).first(count)) != count) {
          throw_damaged_export(export_name(rank));
        }
        for (std::size_t i = 0; i < count; ++i) take(names[i], balls[i], labels, by_ball);
      }
      context_.progress.advance(1);
    }
  }

  void take(const PoleName& name, const PoleBall& ball, const NodeLabels& labels,
            ExternalSort<PoleByBall>& by_ball) {
    if (!std::isfinite(ball.radius)) {
      counts_.unbounded += name.samples;
      return;
    }
    if (name.is_small != 0) {
      counts_.small += name.samples;
      return;
    }
    const bool is_inside = labels.label(name.node) == NodeLabel::kInside;
    by_ball.add({{.tetrahedron = name.tetrahedron,
                  .separation = name.separation,
                  .is_inside = static_cast<std::uint8_t>(is_inside),
                  .unused = {},
                  .centre = ball.centre,
                  .radius = ball.radius},
                 tolerance_});
  }

  void merge(ExternalSort<PoleByBall>& by_ball, ExternalSort<PoleByName>& by_name) {
    std::optional<Coincidence> open;
    by_ball.for_each([&](const PoleByBall& next) {
      if (open && open->takes(next)) {
        open->add(next.pole);
        return;
      }
      if (open) finish(*open, by_name);
      open.emplace(next);
    });
    if (open) finish(*open, by_name);
  }

  void finish(const Coincidence& ball, ExternalSort<PoleByName>& by_name) {
    const Pole pole = ball.merged();
    ++counts_.count;
    ++(pole.is_inside != 0 ? counts_.inner : counts_.outer);
    counts_.coincident += ball.tetrahedra() - 1;
    counts_.conflicts += ball.is_conflict() ? 1 : 0;
    by_name.add({pole});
  }

  void write(ExternalSort<PoleByName>& by_name) {
    const Reservation memory =
        context_.budget.reserve(record_file_memory(kPoleStoreBlock), "writing poles");
    auto store = create_records<Pole>(context_.scratch, kPoleStore, kPoleStoreBlock);
    by_name.for_each([&store](const PoleByName& next) { store.append(next.pole); });
    store.finish();
  }

  const ExportReader& windows_;
  const WindowLabels& labels_;
  const double tolerance_;
  const StageContext& context_;
  std::vector<PointRank> first_ranks_;
  PoleReport counts_;
};

}  // namespace

PoleReport store_poles(const PoleSources& sources, double tolerance, const StageContext& context) {
  return PoleStage(sources.windows, sources.labels, tolerance, context).run();
}

}  // namespace stream_recon
