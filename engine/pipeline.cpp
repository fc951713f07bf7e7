#include "engine/pipeline.h"

#include <memory>
#include <vector>

#include "engine/alpha/alpha_filter.h"
#include "engine/disk_estimate.h"
#include "engine/gamma/gamma_filter.h"
#include "engine/memory_trace.h"
#include "engine/order/hilbert_sort.h"
#include "engine/order/ingest.h"
#include "engine/stage_log.h"
#include "engine/surface/assembly.h"
#include "engine/tetrahedra/tetrahedra_assembly.h"
#include "engine/tetrahedra/tetrahedra_collector.h"
#include "engine/windows/cloud_index.h"
#include "engine/windows/export_reader.h"
#include "engine/windows/window_stage.h"
#include "io/surface_writer.h"
#include "io/tetrahedra_writer.h"

namespace stream_recon {
namespace {

/// What the consumers of a window hold while it is theirs, bytes a thread.
constexpr std::uint64_t kConsumerMemory = std::uint64_t{1} << 20;

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
    const OrderResult order = journal_.once(&Manifest::order, [&] { return sort(cloud); });
    context_.scratch.remove(kIngestSpool);
    const ChunkLayout layout{options_.chunk_points, order.point_count};
    run_windows(cloud, layout);
    const ExportReader exports(context_.scratch, context_.budget);
    if (surface_writer != nullptr) {
      log_.run("surface", [&] { build_surface({exports, layout}, *surface_writer); });
    }
    if (tetrahedra_writer != nullptr) {
      log_.run("tetrahedra", [&] {
        assemble_tetrahedra({exports, layout}, *tetrahedra_writer, context_);
      });
    }
    if (surface_writer != nullptr || tetrahedra_writer != nullptr) {
      log_.run("write", [&] { finish(surface_writer.get(), tetrahedra_writer.get()); });
    }
    report_input(cloud, order);
    report_.stages = log_.stages();
    report_.memory_over_time = trace_.stop();
    report_.seconds = log_.seconds();
  }

 private:
  CloudSummary read_input() {
    const CloudSummary cloud = log_.run("ingest", [&] {
      return ingest({options_.inputs, options_.input_format}, context_);
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
                                .coordinates = scalar_of(cloud),
                                .scratch = &context_.scratch,
                                .has_sheets = options_.manifold});
  }
  std::unique_ptr<TetrahedraWriter> make_tetrahedra_writer(const CloudSummary& cloud) const {
    if (options_.tetrahedra.empty()) return nullptr;
    return std::make_unique<TetrahedraWriter>(
        TetrahedraWriterOptions{options_.tetrahedra, scalar_of(cloud)});
  }

  /// Those that the journal lacks.
  void run_windows(const CloudSummary& cloud, const ChunkLayout& layout) {
    const std::uint64_t points = layout.point_count;
    if (points == 0 || journal_.windows().done_points() < points) {
      const CloudIndex index =
          log_.run("index", [&] { return build_index(cloud, points, context_); });
      log_.run("windows", [&] { build_windows(index, layout); });
      context_.scratch.remove(kIndexPages);
    }
    report_windows(journal_.windows().totals);
  }

  void build_windows(const CloudIndex& index, const ChunkLayout& layout) {
    const Reservation memory =
        context_.budget.reserve(report_.threads * kConsumerMemory, "facets on their way");
    std::vector<WindowConsumer*> consumers;
    std::unique_ptr<FacetFilter> filter;
    if (options_.surface != SurfaceKind::kNone) {
      filter = make_filter(options_, layout, context_.stop);
      consumers.push_back(filter.get());
    }
    TetrahedraCollector collector(layout, context_.stop);
    if (!options_.tetrahedra.empty()) consumers.push_back(&collector);
    run_window_stage({index, consumers, [this](const auto& w) { journal_.note_windows(w); }},
                     journal_.windows(), {report_.threads, options_.window_points}, context_);
  }

  void build_surface(const ExportedFacets& facets, SurfaceWriter& writer) {
    const SurfaceCounts counts = assemble_surface(facets, writer, context_, {.splits = options_.manifold});
    report_.surface.vertices = counts.vertices;
    report_.surface.triangles = counts.triangles;
    report_.surface.boundary_edges = counts.boundary_edges;
    report_.surface.nonmanifold_edges = counts.nonmanifold_edges;
    report_.surface.euler = counts.euler();
    report_.surface.digest = counts.digest.hex();
    report_.surface.delta_histogram = counts.delta_histogram;
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
                       .insert_seconds = totals.counts.insert_seconds,
                       .search_seconds = totals.counts.search_seconds};
  }

  /// All outputs or none: what can run into a full disk comes before the first final name, and the
  /// tetrahedra step back if the surface fails.
  static void finish(SurfaceWriter* surface, TetrahedraWriter* tetrahedra) {
    if (tetrahedra != nullptr) tetrahedra->prepare();
    if (surface != nullptr) surface->prepare();
    if (tetrahedra != nullptr) tetrahedra->publish();
    if (surface != nullptr) surface->finish();
    if (tetrahedra != nullptr) tetrahedra->keep();
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
