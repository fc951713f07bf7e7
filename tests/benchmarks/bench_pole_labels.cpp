// Compares labels of poles, on clouds of solids whose truth is known:
//
//   forest           of the signed forest of tetrahedra, as --surface crust has them
//   priority         spread from the outside, surest first, as the power crust's authors do
//   forest of poles  of a signed forest of the same links
//   damped           the same two, where poles small against the spacing of their samples say less
//   truth            whether the pole's centre is in the solid
//
// It prints a row of a Markdown table each: poles whose label is not the truth; those of them that
// are farther than a mean spacing from the surface; poles that no label has reached, which count as
// outside; and of the crust with these labels the volume that is wrong, against the true volume,
// and the Euler number of its sheets.
//
// The links: poles that touch a far point are outside. Poles of a sample are opposite, by minus
// the cosine of the angle at which it sees them; poles adjacent in the power diagram are neighbours
// where their balls meet, by (r^2 + s^2 - d^2) / (2 r s), above --deep. Source: Amenta, Choi,
// Kolluri, The power crust, 2001, section 4.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "engine/crust/crust_stage.h"
#include "engine/labels/evidence_collector.h"
#include "engine/labels/forest_merge.h"
#include "engine/order/hilbert_sort.h"
#include "engine/order/point_store.h"
#include "engine/parallel.h"
#include "engine/poles/pole_stage.h"
#include "engine/poles/pole_store.h"
#include "engine/poles/star_poles.h"
#include "engine/spacing/spacing_stage.h"
#include "engine/surface/assembly.h"
#include "engine/windows/window_stage.h"
#include "spatial/regular_triangulation.h"
#include "spatial/touching_ball.h"
#include "spatial/vector.h"
#include "tests/benchmarks/label_error.h"
#include "tests/benchmarks/pole_links.h"
#include "tests/engine_fixture.h"
#include "tools/clouds/solid_samples.h"
#include "tools/run_tool.h"

namespace stream_recon {
namespace {

struct CommandLine {
  std::vector<std::string> cases{"folds:random",  "folds:crossings:2", "sponge:random",
                                 "blob:random",   "folds:noisy",       "sponge:noisy",
                                 "blob:noisy",    "uneven:noisy",      "plate:noisy",
                                 "folds:faces:1", "folds:centres:1",   "folds:centres:4"};
  std::uint64_t points = 50'000;
  double noise = 0.25;
  double deep = 0;
  unsigned threads = 2;
  double cell = 0.01;
};

constexpr std::uint64_t kMemory = std::uint64_t{2} << 30;

/// SOLID:SAMPLING[:STEP]
SolidSampleOptions parse_case(const std::string& text, const CommandLine& line) {
  const auto first = text.find(':');
  const auto second = text.find(':', first + 1);
  if (first == std::string::npos) throw std::invalid_argument("not SOLID:SAMPLING: " + text);
  SolidSampleOptions options;
  options.solid.name = text.substr(0, first);
  const std::string sampling = text.substr(first + 1, second - first - 1);
  const auto& names = kSolidSamplingNames;
  const auto* const name = std::find(names.begin(), names.end(), sampling);
  if (name == names.end()) throw std::invalid_argument("no such sampling: " + text);
  options.sampling = static_cast<SolidSampling>(name - names.begin());
  options.points = line.points;
  options.noise = line.noise;
  options.slice_step = second == std::string::npos
                           ? 1
                           : static_cast<std::uint32_t>(std::stoul(text.substr(second + 1)));
  return options;
}

/// A triangle's corners for the meter; nothing is written.
class MeterWriter final : public SurfaceWriter {
 public:
  explicit MeterWriter(LabelErrorMeter& meter) : meter_(meter) {}
  bool takes_chunks_in_order() const override { return false; }
  void write(std::uint64_t /*number*/, const SurfaceChunk& chunk) override {
    const std::lock_guard lock(mutex_);
    for (const auto& [a, b, c] : chunk.triangles)
      meter_.add_triangle({chunk.points[a], chunk.points[b], chunk.points[c]});
  }
  std::uint64_t bytes_written() const override { return 0; }

 private:
  void complete() override {}
  void publish() override {}

  LabelErrorMeter& meter_;
  std::mutex mutex_;
};

template <class Record>
std::vector<Record> read_all(const ScratchDirectory& scratch, const std::string& name) {
  ScratchReader<Record> reader(scratch, name);
  std::vector<Record> all(reader.count());
  reader.read(all);
  return all;
}

/// A cloud with its poles, labelled by the forest, made by the program's own stages.
class LabelledCloud {
 public:
  LabelledCloud(const SolidSampleOptions& options, unsigned threads)
      : threads_(threads), stage_(kMemory) {
    write_samples(*sample_solid(options));
    const StageContext& context = stage_.context;
    cloud_ =
        ingest({.inputs = {path()}, .format = InputFormat::kF64, .adds_far_points = true}, context);
    count_ = hilbert_sort(cloud_, context).point_count;
    {
      const CloudIndex index = build_index(cloud_, count_, context);
      scale_ = index.scale;
      measure_spacing(index, grid_, context);
      build_windows(index);
    }
    stage_.scratch.remove(kIndexPages);
    const ExportReader exports(stage_.scratch, stage_.budget);
    const MergedForest forest = merge_forest(exports, context);
    store_poles({exports, forest.labels}, 0, context);
  }

  std::vector<Pole> poles() const { return read_all<Pole>(stage_.scratch, kPoleStore); }
  /// In the order of their ranks.
  std::vector<StoredPoint> points() const {
    return read_all<StoredPoint>(stage_.scratch, kPointStore);
  }
  bool is_far(const StoredPoint& point) const { return point.input_index >= cloud_.points; }
  /// Of every rank, units of the input.
  std::vector<double> spacings() const {
    const auto scaled_ones = read_all<float>(stage_.scratch, kSpacings);
    std::vector<double> spacings(scaled_ones.begin(), scaled_ones.end());
    for (double& spacing : spacings) spacing /= scale_;
    return spacings;
  }
  double scale() const { return scale_; }
  std::uint64_t samples() const { return count_ - cloud_.far_points; }

  /// The crust of the poles as they are labelled here.
  SurfaceFacts crust(const std::vector<Pole>& poles, SurfaceWriter& writer) {
    stage_.scratch.remove(kPoleStore);
    auto store = create_records<Pole>(stage_.scratch, kPoleStore, kPoleStoreBlock);
    store.append(std::span<const Pole>(poles));
    store.finish();
    const auto before = stage_.scratch.names();
    const SurfaceFacts facts = crust_of_store(writer);
    for (const std::string& name : stage_.scratch.names()) {
      const bool is_new = std::find(before.begin(), before.end(), name) == before.end();
      if (is_new) stage_.scratch.remove(name);
    }
    return facts;
  }

 private:
  SurfaceFacts crust_of_store(SurfaceWriter& writer) {
    constexpr std::uint64_t kChunk = 100'000;
    const CrustSurface crust =
        build_crust(cloud_, count_, {.threads = threads_, .chunk_points = kChunk}, stage_.context);
    const ExportReader facets(stage_.scratch, stage_.budget, kCrustPrefix);
    return assemble_surface({facets, {kChunk, crust.facts.vertices}, kCrustPoints}, writer,
                            stage_.context,
                            {.is_solid = true, .splits = false, .range = crust.facts.range});
  }

  std::string path() const { return stage_.folder / "cloud.f64"; }

  void write_samples(PointSource& source) {
    std::vector<Point3> samples;
    std::vector<Point3> batch(4096);
    while (const std::size_t n = source.read(batch))
      samples.insert(samples.end(), batch.begin(), batch.begin() + static_cast<std::ptrdiff_t>(n));
    grid_ = source.metadata().spacing;
    put_bytes(path(),
              {reinterpret_cast<const char*>(samples.data()), samples.size() * sizeof(Point3)});
  }

  void build_windows(const CloudIndex& index) {
    const std::uint64_t bytes = SpacingCache::memory(count_, threads_, stage_.budget.available());
    SpacingCache spacings(stage_.scratch, index, bytes);
    EvidenceCollector evidence(spacings, stage_.stop,
                               {.hands_on_poles = true, .samples = cloud_.points});
    const std::array<WindowConsumer*, 1> consumers{&evidence};
    run_window_stage({index, consumers, {}}, {},
                     {.threads = threads_,
                      .consumer_bytes_a_point = EvidenceCollector::kBytesAnOwnedPoint,
                      .whole_stars = true},
                     stage_.context);
  }

  unsigned threads_;
  StageFixture stage_;
  std::optional<SampleSpacing> grid_;
  CloudSummary cloud_;
  std::uint64_t count_ = 0;
  double scale_ = 1;
};

/// What joins the poles of a cloud, found in core.
class PoleGraph {
 public:
  PoleGraph(const LabelledCloud& cloud, const std::vector<Pole>& poles, double deep)
      : cloud_(cloud), poles_(poles), stored_(cloud.points()), spacings_(cloud.spacings()) {
    for (const StoredPoint& s : stored_) {
      points_.push_back(s.point);
      indices_.push_back(s.input_index);
    }
    number_poles();
    find_opposite();
    find_neighbours(deep);
    for (std::uint32_t p = 0; p < poles_.size(); ++p) {
      const auto& ranks = poles_[p].tetrahedron.ranks;
      if (std::any_of(ranks.begin(), ranks.end(),
                      [&](std::uint32_t rank) { return cloud_.is_far(stored_[rank]); }))
        outside_.push_back(p);
    }
  }

  std::uint32_t count() const { return static_cast<std::uint32_t>(poles_.size()); }
  const std::vector<PoleLink>& links() const { return links_; }
  /// Less where a ball is smaller than the spacing of its samples, as the program's evidence.
  std::vector<PoleLink> damped_links() const {
    std::vector<PoleLink> links = links_;
    for (PoleLink& link : links) link.weight *= std::min(trust(link.a), trust(link.b));
    return links;
  }
  /// Poles that touch a far point.
  const std::vector<std::uint32_t>& outside() const { return outside_; }

 private:
  using Ball = std::tuple<double, double, double, double>;

  static Ball ball(const Point3& centre, double radius) {
    return {centre.x, centre.y, centre.z, radius};
  }

  /// Equal balls are one pole, so a ball is its name.
  void number_poles() {
    for (std::uint32_t p = 0; p < poles_.size(); ++p)
      numbers_.emplace_back(ball(poles_[p].centre, poles_[p].radius), p);
    std::sort(numbers_.begin(), numbers_.end());
  }
  std::uint32_t number(const FinalWindow& window, const CellView& cells, CellId cell) const {
    const TouchingBall of = touching_ball(RankedCell(window, cells, cell).corners(cells));
    const auto wanted = std::pair(ball(of.centre, of.radius), std::uint32_t{0});
    const auto found = std::lower_bound(numbers_.begin(), numbers_.end(), wanted);
    if (found == numbers_.end() || found->first != wanted.first)
      throw std::logic_error("a pole that is not stored");
    return found->second;
  }

  void find_opposite() {
    Delaunay delaunay;
    if (delaunay.insert(points_) != Delaunay::Outcome::kDone) throw std::logic_error("no cells");
    const FinalWindow window({.delaunay = &delaunay,
                              .owned_count = points_.size(),
                              .guest_ranks = {},
                              .input_indices = indices_});
    const StarBalls balls(window, cloud_.scale());
    const StarPoles pairs(window, balls);
    const CellView cells = delaunay.view();
    for (VertexId v = 0; v < points_.size(); ++v) {
      const PolePair pair = pairs.pair(v);
      if (cloud_.is_far(stored_[v]) || !pair.is_complete()) continue;
      const std::uint32_t a = number(window, cells, pair.first);
      const std::uint32_t b = number(window, cells, pair.second);
      const Point3 to_a = minus(poles_[a].centre, points_[v]);
      const Point3 to_b = minus(poles_[b].centre, points_[v]);
      const double weight = -dot(to_a, to_b) / (length(to_a) * length(to_b));
      if (weight > 0) links_.push_back({a, b, weight, true});
    }
  }

  void find_neighbours(double deep) {
    std::vector<WeightedPoint3> sites;
    for (const Pole& pole : poles_) sites.push_back({pole.centre, pole.radius * pole.radius});
    RegularTriangulation diagram;
    if (diagram.insert(sites) != Delaunay::Outcome::kDone) throw std::logic_error("no diagram");
    const WeightedCellView cells = diagram.view();
    std::vector<std::pair<VertexId, VertexId>> edges;
    for (CellId c = 0; c < cells.slots(); ++c) {
      if (!cells.is_live(c) || cells.is_infinite(c)) continue;
      auto v = cells.vertices(c);
      std::sort(v.begin(), v.end());
      for (int i = 0; i < 4; ++i)
        for (int j = i + 1; j < 4; ++j) edges.emplace_back(v[i], v[j]);
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    for (const auto& [a, b] : edges) {
      const double r = poles_[a].radius;
      const double s = poles_[b].radius;
      const Point3 between = minus(poles_[a].centre, poles_[b].centre);
      const double weight = (r * r + s * s - dot(between, between)) / (2 * r * s);
      if (weight > deep) links_.push_back({a, b, std::min(weight, 1.0), false});
    }
  }

  double trust(std::uint32_t pole) const {
    double spacing = 0;
    for (const std::uint32_t rank : poles_[pole].tetrahedron.ranks)
      if (!cloud_.is_far(stored_[rank])) spacing = std::max(spacing, spacings_[rank]);
    return spacing > 0 ? std::min(1.0, poles_[pole].radius / spacing) : 1;
  }

  const LabelledCloud& cloud_;
  const std::vector<Pole>& poles_;
  std::vector<StoredPoint> stored_;
  std::vector<double> spacings_;
  std::vector<Point3> points_;
  std::vector<std::uint64_t> indices_;
  std::vector<std::pair<Ball, std::uint32_t>> numbers_;
  std::vector<PoleLink> links_;
  std::vector<std::uint32_t> outside_;
};

class Comparison {
 public:
  Comparison(std::string name, const CommandLine& line)
      : name_(std::move(name)),
        line_(line),
        options_(parse_case(name_, line)),
        solid_(make_solid(options_.solid)),
        cloud_(options_, line.threads) {}

  void run() {
    const std::vector<Pole> forest = cloud_.poles();
    const PoleGraph graph(cloud_, forest, line_.deep);
    row("forest", forest, 0);
    const auto& outside = graph.outside();
    const std::vector<PoleLink> damped = graph.damped_links();
    linked("priority", forest, priority_labels(graph.count(), graph.links(), outside));
    linked("priority, damped", forest, priority_labels(graph.count(), damped, outside));
    linked("forest of poles", forest, forest_labels(graph.count(), graph.links(), outside));
    linked("forest of poles, damped", forest, forest_labels(graph.count(), damped, outside));
    std::vector<Pole> truth = forest;
    for (Pole& pole : truth) pole.is_inside = solid_->contains(pole.centre) ? 1 : 0;
    row("truth", truth, 0);
  }

 private:
  void linked(const char* how, std::vector<Pole> poles, const std::vector<LinkLabel>& labels) {
    for (std::size_t p = 0; p < poles.size(); ++p)
      poles[p].is_inside = labels[p] == LinkLabel::kInside ? 1 : 0;
    row(how, poles, std::count(labels.begin(), labels.end(), LinkLabel::kNone));
  }

  void row(const char* how, const std::vector<Pole>& poles, std::ptrdiff_t unreached) {
    const SolidTruth truth = solid_->truth();
    const double spacing = std::sqrt(truth.area / static_cast<double>(cloud_.samples()));
    std::uint64_t wrong = 0;
    std::uint64_t clear = 0;
    for (const Pole& pole : poles) {
      const double bound = solid_->signed_bound(pole.centre);
      if ((bound < 0) == (pole.is_inside != 0)) continue;
      ++wrong;
      clear += std::abs(bound) > spacing ? 1 : 0;
    }
    LabelErrorMeter meter(*solid_, line_.cell);
    MeterWriter writer(meter);
    const SurfaceFacts facts = cloud_.crust(poles, writer);
    const LabelError error = meter.measure();
    const auto sheets = static_cast<std::int64_t>(facts.components + facts.cavities);
    const std::string euler =
        facts.genus ? fmt::format("{}", 2 * (sheets - *facts.genus)) : std::string("open");
    fmt::print("| {} | {} | {} | {} | {} | {} | {:.2f} % | {} | {} |\n", name_, poles.size(), how,
               wrong, clear, unreached, 100 * error.wrong_volume / truth.volume, euler,
               truth.euler);
    std::fflush(stdout);
  }

  std::string name_;
  const CommandLine& line_;
  SolidSampleOptions options_;
  std::unique_ptr<const KnownSolid> solid_;
  LabelledCloud cloud_;
};

void compare(const CommandLine& line) {
  const ThreadLimit limit(line.threads);
  fmt::print(
      "| cloud | poles | labels | wrong | of these clear | unreached | wrong volume | chi | true "
      "|\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const std::string& name : line.cases) Comparison(name, line).run();
}

}  // namespace
}  // namespace stream_recon

int main(int argc, char** argv) {
  CLI::App app("Compares labels of poles on known solids", "bench-pole-labels");
  stream_recon::CommandLine line;
  app.add_option("CASES", line.cases, "SOLID:SAMPLING[:STEP] ...")->capture_default_str();
  app.add_option("-n,--points", line.points, "Samples of each")->capture_default_str();
  app.add_option("--noise", line.noise, "Of noisy samples, mean spacings")->capture_default_str();
  app.add_option("--deep", line.deep, "Least weight of neighbours")->capture_default_str();
  app.add_option("--threads", line.threads, "Threads")->capture_default_str();
  app.add_option("--cell", line.cell, "Distance of the rays that measure volume")
      ->capture_default_str();
  return stream_recon::run_tool(app, argc, argv, [&line] { stream_recon::compare(line); });
}
