#include "engine/pipeline.h"

#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/alpha/alpha_filter.h"
#include "engine/crust/crust_stage.h"
#include "engine/disk_estimate.h"
#include "engine/gamma/gamma_filter.h"
#include "engine/hybrid/hybrid_stage.h"
#include "engine/labels/evidence_collector.h"
#include "engine/labels/facet_labels.h"
#include "engine/labels/forest_merge.h"
#include "engine/memory_trace.h"
#include "engine/order/hilbert_sort.h"
#include "engine/order/ingest.h"
#include "engine/poles/medial_axis.h"
#include "engine/poles/pole_stage.h"
#include "engine/spacing/spacing_reader.h"
#include "engine/spacing/spacing_stage.h"
#include "engine/stage_log.h"
#include "engine/surface/assembly.h"
#include "engine/tetrahedra/tetrahedra_assembly.h"
#include "engine/tetrahedra/tetrahedra_collector.h"
#include "engine/windows/cloud_index.h"
#include "engine/windows/export_reader.h"
#include "engine/windows/window_stage.h"
#include "io/medial_axis_writer.h"
#include "io/points_writer.h"
#include "io/surface_writer.h"
#include "io/tetrahedra_writer.h"

namespace stream_recon {
namespace {

/// What the consumers of a window hold while it is theirs, bytes a thread.
constexpr std::uint64_t kConsumerMemory = std::uint64_t{1} << 20;

/// Ranks have 32 bits in the records of evidence, one of which is for infinity.
constexpr std::uint64_t kMostSolidPoints = 0xfffffffe;

std::unique_ptr<FacetFilter> make_filter(const RunOptions& options, const ChunkLayout& layout,
                                         const StopRequest& stop) {
  if (options.surface == SurfaceKind::kAlpha) {
    return std::make_unique<AlphaFilter>(options.alpha, layout, stop);
  }
  return std::make_unique<GammaFilter>(options.delta_max_degrees, layout, stop);
}

Scalar scalar_of(const CloudSummary& cloud) {
  return cloud.fits_float32 ? Scalar::kFloat32 : Scalar::kFloat64;
}

class Pipeline {
 public:
  Pipeline(const RunOptions& options, const StageContext& context, RunJournal& journal,
           Report& report)
      : options_(options), context_(context), journal_(journal), report_(report) {}

  void run() {
    const CloudSummary cloud = journal_.once(&Manifest::cloud, [&] { return read_input(); });
    tell_disk(cloud);
    const auto surface_writer = make_writer(cloud);
    const auto tetrahedra_writer = make_tetrahedra_writer(cloud);
    const auto unused_writer = make_unused_writer(cloud);
    const auto axis_writer = make_axis_writer();
    const OrderResult order = journal_.once(&Manifest::order, [&] { return sort(cloud); });
    context_.scratch.remove(kIngestSpool);
    const ChunkLayout layout{options_.chunk_points, order.point_count};
    run_windows(cloud, layout);
    const ExportReader exports(context_.scratch, context_.budget);
    if (options_.needs_labels()) label(exports, layout);
    if (is_hybrid()) {
      close_holes(cloud, layout);
      surface_cloud(cloud, layout, {surface_writer.get(), nullptr, nullptr, nullptr});
    } else if (options_.needs_power()) {
      const CrustSurface crust = divide(cloud, order);
      if (surface_writer != nullptr) surface_crust(crust, *surface_writer);
    } else if (surface_writer != nullptr) {
      surface_cloud(cloud, layout, {surface_writer.get(), nullptr, unused_writer.get(), nullptr});
    }
    if (tetrahedra_writer != nullptr) {
      log_.run("tetrahedra", [&] {
        assemble_tetrahedra({exports, layout}, *tetrahedra_writer, context_);
      });
    }
    if (axis_writer != nullptr) {
      log_.run("medial axis", [&] { write_axis(layout, *axis_writer); });
    }
    if (surface_writer != nullptr || tetrahedra_writer != nullptr || axis_writer != nullptr) {
      log_.run("write", [&] {
        finish({surface_writer.get(), tetrahedra_writer.get(), unused_writer.get(),
                axis_writer.get()});
      });
    }
    report_input(cloud, order);
    report_samples(cloud, order);
    report_.stages = log_.stages();
    report_.memory_over_time = trace_.stop();
    report_.seconds = log_.seconds();
  }

 private:
  struct Writers {
    SurfaceWriter* surface;
    TetrahedraWriter* tetrahedra;
    PointsWriter* unused;
    MedialAxisWriter* axis;
  };

  CloudSummary read_input() {
    const CloudSummary cloud = log_.run("ingest", [&] {
      return ingest({.inputs = options_.inputs,
                     .format = options_.input_format,
                     .adds_far_points = options_.needs_power()},
                    context_);
    });
    log_.add_bytes_read(cloud.bytes);
    return cloud;
  }

  void tell_disk(const CloudSummary& cloud) const {
    const DiskOutlook outlook = disk_outlook(estimate_disk(cloud.finite_points(), options_),
                                             options_, context_.scratch.used_bytes());
    context_.progress.note(outlook.text);
    if (outlook.is_short) {
      options_.say(outlook.text + ": the disk may become full; the run can then be resumed");
    }
  }

  OrderResult sort(const CloudSummary& cloud) {
    return log_.run("order", [&] { return hilbert_sort(cloud, context_); });
  }

  /// Made before the work, so that a name that cannot be written is found out early.
  std::unique_ptr<SurfaceWriter> make_writer(const CloudSummary& cloud) const {
    if (options_.surface == SurfaceKind::kNone) return nullptr;
    return make_surface_writer({.path = options_.output,
                                .coordinates = is_crust() ? Scalar::kFloat64 : scalar_of(cloud),
                                .scratch = &context_.scratch,
                                .has_closure = is_solid(),
                                .has_sheets = options_.manifold});
  }
  std::unique_ptr<TetrahedraWriter> make_tetrahedra_writer(const CloudSummary& cloud) const {
    if (options_.tetrahedra.empty()) return nullptr;
    return std::make_unique<TetrahedraWriter>(
        TetrahedraWriterOptions{options_.tetrahedra, scalar_of(cloud)});
  }

  std::unique_ptr<PointsWriter> make_unused_writer(const CloudSummary& cloud) const {
    if (options_.unused.empty()) return nullptr;
    return std::make_unique<PointsWriter>(
        PointsWriterOptions{options_.unused, scalar_of(cloud), &context_.scratch});
  }

  std::unique_ptr<MedialAxisWriter> make_axis_writer() const {
    if (options_.medial_axis.empty()) return nullptr;
    return std::make_unique<MedialAxisWriter>(options_.medial_axis, options_.medial_axis_faces);
  }

  bool is_crust() const { return options_.surface == SurfaceKind::kCrust; }
  bool is_solid() const { return options_.surface == SurfaceKind::kSolid; }
  bool is_hybrid() const { return options_.surface == SurfaceKind::kHybrid; }
  /// Whether the surface is made of facets between inside and outside.
  bool bounds_solid() const { return is_solid() || is_hybrid(); }

  /// Those that the journal lacks.
  void run_windows(const CloudSummary& cloud, const ChunkLayout& layout) {
    const std::uint64_t points = layout.point_count;
    if (points == 0 || journal_.windows().done_points() < points) {
      const CloudIndex index =
          log_.run("index", [&] { return build_index(cloud, points, context_); });
      const bool needs_labels = options_.needs_labels();
      if (needs_labels) log_.run("spacing", [&] { measure_spacings(cloud, index); });
      log_.run("windows", [&] { build_windows(cloud, index, layout); });
      context_.scratch.remove(kIndexPages);
      if (needs_labels) context_.scratch.remove(kSpacings);
    }
    report_windows(journal_.windows().totals);
  }

  void measure_spacings(const CloudSummary& cloud, const CloudIndex& index) const {
    if (index.point_count > kMostSolidPoints) {
      throw InputError(
          fmt::format("{} points are more than the {} that can be labelled inside and outside; "
                      "use --surface gamma without --medial-axis, or split the cloud",
                      index.point_count, kMostSolidPoints));
    }
    measure_spacing(index, options_.grid_spacing ? options_.grid_spacing : cloud.spacing, context_);
  }

  void build_windows(const CloudSummary& cloud, const CloudIndex& index,
                     const ChunkLayout& layout) {
    const Reservation memory =
        context_.budget.reserve(report_.threads * kConsumerMemory, "facets on their way");
    std::vector<WindowConsumer*> consumers;
    std::unique_ptr<FacetFilter> filter;
    std::optional<SpacingCache> spacings;
    std::optional<EvidenceCollector> evidence;
    Reservation cache;
    WindowStageOptions stage{.threads = report_.threads, .window_points = options_.window_points};
    if (options_.needs_labels()) {
      const std::uint64_t bytes =
          SpacingCache::memory(index.point_count, report_.threads, context_.budget.available());
      cache = context_.budget.reserve(bytes, "the spacings of points");
      spacings.emplace(context_.scratch, index, bytes);
      evidence.emplace(*spacings, context_.stop,
                       EvidenceOptions{.hands_on_poles = options_.needs_poles(),
                                       .samples = cloud.points,
                                       .least_ball = options_.least_ball});
      consumers.push_back(&*evidence);
      stage.consumer_bytes_a_point = EvidenceCollector::kBytesAnOwnedPoint;
      stage.whole_stars = true;
    } else if (options_.surface != SurfaceKind::kNone) {
      filter = make_filter(options_, layout, context_.stop);
      consumers.push_back(filter.get());
    }
    TetrahedraCollector collector(layout, context_.stop);
    if (!options_.tetrahedra.empty()) consumers.push_back(&collector);
    run_window_stage({index, consumers, [this](const auto& w) { journal_.note_windows(w); }},
                     journal_.windows(), stage, context_);
  }

  /// From the windows' evidence to the facets of the surface and the poles.
  void label(const ExportReader& exports, const ChunkLayout& layout) {
    const MergedForest forest = log_.run("labels", [&] {
      MergedForest merged = merge_forest(exports, context_);
      if (bounds_solid()) export_solid(exports, layout, merged.labels);
      return merged;
    });
    if (!options_.needs_poles()) return;
    log_.run("poles", [&] {
      report_.poles = store_poles({exports, forest.labels}, options_.pole_tolerance, context_);
    });
  }

  void export_solid(const ExportReader& exports, const ChunkLayout& layout,
                    const WindowLabels& labels) {
    for (const std::string& name : context_.scratch.names()) {
      if (export_first_rank(name, kLabelledPrefix) || export_first_rank(name, kFillsPrefix)) {
        context_.scratch.remove(name);
      }
    }
    const FacetLabelOptions options{{layout, options_.open_ratio}, is_hybrid()};
    report_.surface.forest_conflicts = label_facets(exports, labels, options, context_).conflicts;
  }

  void write_axis(const ChunkLayout& layout, MedialAxisWriter& writer) const {
    const PoleSide side = options_.medial_axis_side;
    write_medial_axis({.layout = layout,
                       .takes_inner = side != PoleSide::kOuter,
                       .takes_outer = side != PoleSide::kInner,
                       .has_faces = options_.medial_axis_faces},
                      writer, context_);
  }

  void surface_cloud(const CloudSummary& cloud, const ChunkLayout& layout, const Writers& writers) {
    const ExportReader facets(context_.scratch, context_.budget,
                              bounds_solid() ? kLabelledPrefix : kExportPrefix);
    log_.run("surface", [&] {
      build_surface({facets, layout}, *writers.surface,
                    {.is_solid = bounds_solid(),
                     .splits = options_.manifold,
                     .range = cloud.range,
                     .unused = writers.unused});
    });
  }

  /// The hybrid: patches for the holes of the gamma shape, beside its facets.
  void close_holes(const CloudSummary& cloud, const ChunkLayout& layout) {
    const HybridResult hybrid = log_.run("hybrid", [&] {
      return build_hybrid(cloud,
                          {.threads = report_.threads,
                           .window_points = options_.window_points,
                           .layout = layout,
                           .fills_rest = options_.fills_with_solid},
                          context_);
    });
    report_.hybrid = hybrid.report;
    report_power(hybrid.power);
  }

  /// Space among the poles: the crust, the power shape, or both.
  CrustSurface divide(const CloudSummary& cloud, const OrderResult& order) {
    CrustSurface crust = log_.run(is_crust() ? "crust" : "power shape", [&] {
      return build_crust(cloud, order.point_count,
                         {.threads = report_.threads,
                          .window_points = options_.window_points,
                          .chunk_points = options_.chunk_points,
                          .has_crust = is_crust(),
                          .has_shape = options_.medial_axis_faces},
                         context_);
    });
    report_power(crust.power);
    if (options_.medial_axis_faces) {
      report_.shape = {.vertices = crust.shape.vertices,
                       .edges = crust.shape.edges,
                       .bare_edges = crust.shape.bare_edges,
                       .triangles = crust.shape.triangles,
                       .tetrahedra = crust.shape.tetrahedra};
    }
    return crust;
  }

  void report_power(const PowerTotals& power) {
    report_.power = {.windows = power.windows,
                     .poles = power.counts.owned,
                     .guests = power.counts.guests,
                     .rounds = power.counts.rounds,
                     .walks = power.counts.walks,
                     .tests = power.counts.tests,
                     .unbounded_faces = power.unbounded,
                     .seconds = power.counts.seconds};
  }

  void surface_crust(const CrustSurface& crust, SurfaceWriter& writer) {
    const ExportReader facets(context_.scratch, context_.budget, kCrustPrefix);
    const ChunkLayout layout{options_.chunk_points, crust.facts.vertices};
    log_.run("surface", [&] {
      build_surface({facets, layout, kCrustPoints}, writer,
                    {.is_solid = true, .splits = options_.manifold, .range = crust.facts.range});
    });
    report_.surface.samples_on_surface = crust.facts.samples;
  }

  void build_surface(const ExportedFacets& facets, SurfaceWriter& writer,
                     const AssemblyOptions& options) {
    const SurfaceFacts facts = assemble_surface(facets, writer, context_, options);
    const SurfaceCounts& counts = facts.counts;
    report_.surface.vertices = counts.vertices;
    report_.surface.triangles = counts.triangles;
    report_.surface.boundary_edges = counts.boundary_edges;
    report_.surface.nonmanifold_edges = counts.nonmanifold_edges;
    report_.surface.euler = counts.euler();
    report_.surface.digest = counts.digest.hex();
    report_.surface.delta_histogram = counts.delta_histogram;
    report_.surface.doubtful_fills = counts.doubtful_fills;
    report_.surface.samples_on_surface = facts.samples;
    report_.surface.components = facts.components;
    report_.surface.cavities = facts.cavities;
    report_.surface.genus = facts.genus;
    report_.surface.volume = facts.volume;
    report_.surface.area = facts.area;
  }

  void report_samples(const CloudSummary& cloud, const OrderResult& order) {
    if (options_.surface == SurfaceKind::kNone) return;
    report_.surface.unused_samples =
        order.point_count - cloud.far_points - report_.surface.samples_on_surface;
  }

  void report_input(const CloudSummary& cloud, const OrderResult& order) {
    report_.input = {cloud.points, order.duplicates, cloud.rejected, cloud.spacing};
  }

  void report_windows(const WindowTotals& totals) {
    report_.delaunay = {totals.tetrahedra.count, totals.tetrahedra.digest.hex()};
    report_.windows = {.count = totals.windows,
                       .splits = totals.splits,
                       .guests = totals.counts.guests,
                       .rounds = totals.counts.rounds,
                       .queries = totals.counts.search.queries,
                       .node_visits = totals.counts.search.node_visits,
                       .exact_tests = totals.counts.search.exact_tests,
                       .insert_seconds = totals.counts.insert_seconds,
                       .search_seconds = totals.counts.search_seconds};
  }

  /// All outputs or none: what can run into a full disk comes before the first final name, and the
  /// others step back if the surface fails.
  static void finish(const Writers& writers) {
    const auto& [surface, tetrahedra, unused, axis] = writers;
    if (tetrahedra != nullptr) tetrahedra->prepare();
    if (unused != nullptr) unused->prepare();
    if (axis != nullptr) axis->prepare();
    if (surface != nullptr) surface->prepare();
    if (tetrahedra != nullptr) tetrahedra->publish();
    if (unused != nullptr) unused->publish();
    if (axis != nullptr) axis->publish();
    if (surface != nullptr) surface->finish();
    if (tetrahedra != nullptr) tetrahedra->keep();
    if (unused != nullptr) unused->keep();
    if (axis != nullptr) axis->keep();
  }

  const RunOptions& options_;
  const StageContext& context_;
  RunJournal& journal_;
  Report& report_;
  StageLog log_;
  MemoryTrace trace_;
};

}  // namespace

void run_pipeline(const RunOptions& options, const StageContext& context, RunJournal& journal,
                  Report& report) {
  Pipeline(options, context, journal, report).run();
}

}  // namespace stream_recon
