#include "engine/pipeline.h"

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "engine/alpha/alpha_filter.h"
#include "engine/gamma/gamma_filter.h"
#include "engine/order/hilbert_sort.h"
#include "engine/order/ingest.h"
#include "engine/stage_log.h"
#include "engine/surface/assembly.h"
#include "engine/surface/facet_sink.h"
#include "engine/tetrahedra/tetrahedra_assembly.h"
#include "engine/tetrahedra/tetrahedra_collector.h"
#include "engine/tetrahedra/tetrahedra_sink.h"
#include "engine/windows/cloud_index.h"
#include "engine/windows/tetrahedra_census.h"
#include "engine/windows/window_stage.h"
#include "io/surface_writer.h"
#include "io/tetrahedra_writer.h"

namespace stream_recon {
namespace {

/// Facets that tasks have found and not yet handed to the sink, bytes.
constexpr std::uint64_t kConsumerMemory = std::uint64_t{8} << 20;

std::unique_ptr<FacetFilter> make_filter(const RunOptions& options, FacetSink& sink,
                                         const StopRequest& stop) {
  if (options.surface == SurfaceKind::kAlpha) {
    return std::make_unique<AlphaFilter>(options.alpha, sink, stop);
  }
  return std::make_unique<GammaFilter>(options.delta_max_degrees, sink, stop);
}

Scalar scalar_of(const CloudSummary& cloud) {
  return cloud.fits_float32 ? Scalar::kFloat32 : Scalar::kFloat64;
}

class Pipeline {
 public:
  Pipeline(const RunOptions& options, const StageContext& context, Report& report)
      : options_(options), context_(context), report_(report) {}

  void run() {
    const CloudSummary cloud = log_.run("ingest", [&] { return read_input(); });
    log_.add_bytes_read(cloud.bytes);
    const auto writer = make_writer(cloud);
    const auto tetrahedra_writer = make_tetrahedra_writer(cloud);
    const OrderResult order = log_.run("order", [&] { return hilbert_sort(cloud, context_); });
    report_.input.duplicates = order.duplicates;
    auto facets = make_sink<FacetSink>(order, writer != nullptr);
    const auto tetrahedra = make_sink<TetrahedraSink>(order, tetrahedra_writer != nullptr);
    {
      const CloudIndex index =
          log_.run("index", [&] { return build_index(cloud, order.point_count, context_); });
      log_.run("windows", [&] { run_windows(index, facets.get(), tetrahedra.get()); });
      context_.scratch.remove(kIndexPages);
    }
    if (facets != nullptr) log_.run("surface", [&] { build_surface(*facets, *writer); });
    facets.reset();
    if (tetrahedra != nullptr) {
      log_.run("tetrahedra",
               [&] { assemble_tetrahedra(*tetrahedra, *tetrahedra_writer, context_); });
    }
    if (writer != nullptr || tetrahedra_writer != nullptr) {
      log_.run("write", [&] { finish(writer.get(), tetrahedra_writer.get()); });
    }
    report_.stages = log_.stages();
    report_.seconds = log_.seconds();
  }

 private:
  CloudSummary read_input() {
    const CloudSummary cloud = ingest({options_.inputs, options_.input_format}, context_);
    report_.input.points = cloud.points;
    report_.input.rejected = cloud.rejected;
    return cloud;
  }

  /// Made before the work, so that a name that cannot be written is found out early.
  std::unique_ptr<SurfaceWriter> make_writer(const CloudSummary& cloud) const {
    if (options_.surface == SurfaceKind::kNone) return nullptr;
    return make_surface_writer({options_.output, scalar_of(cloud), &context_.scratch});
  }
  std::unique_ptr<TetrahedraWriter> make_tetrahedra_writer(const CloudSummary& cloud) const {
    if (options_.tetrahedra.empty()) return nullptr;
    return std::make_unique<TetrahedraWriter>(
        TetrahedraWriterOptions{options_.tetrahedra, scalar_of(cloud)});
  }

  template <class Sink>
  std::unique_ptr<Sink> make_sink(const OrderResult& order, bool is_wanted) const {
    if (!is_wanted) return nullptr;
    const ChunkLayout layout{options_.chunk_points, order.point_count};
    return std::make_unique<Sink>(layout, SpoolOptions{&context_.scratch, &context_.budget});
  }

  void run_windows(const CloudIndex& index, FacetSink* facets, TetrahedraSink* tetrahedra) {
    const Reservation memory = context_.budget.reserve(kConsumerMemory, "facets on their way");
    TetrahedraCensus census;
    std::vector<WindowConsumer*> consumers{&census};
    std::unique_ptr<FacetFilter> filter;
    if (facets != nullptr) {
      filter = make_filter(options_, *facets, context_.stop);
      consumers.push_back(filter.get());
    }
    std::optional<TetrahedraCollector> collector;
    if (tetrahedra != nullptr) {
      consumers.push_back(&collector.emplace(*tetrahedra, context_.stop));
    }
    const WindowStageResult result =
        run_window_stage(index, consumers, {report_.threads, options_.window_points}, context_);
    if (facets != nullptr) facets->finish();
    if (tetrahedra != nullptr) tetrahedra->finish();

    report_.delaunay = {census.count(), census.digest().hex()};
    report_.windows = {.count = result.windows,
                       .splits = result.splits,
                       .guests = result.counts.guests,
                       .rounds = result.counts.rounds,
                       .queries = result.counts.search.queries,
                       .node_visits = result.counts.search.node_visits,
                       .insert_seconds = result.counts.insert_seconds,
                       .search_seconds = result.counts.search_seconds};
  }

  void build_surface(const FacetSink& facets, SurfaceWriter& writer) {
    const SurfaceCounts counts = assemble_surface(facets, writer, context_);
    report_.surface.vertices = counts.vertices;
    report_.surface.triangles = counts.triangles;
    report_.surface.boundary_edges = counts.boundary_edges;
    report_.surface.nonmanifold_edges = counts.nonmanifold_edges;
    report_.surface.euler = counts.euler();
    report_.surface.digest = counts.digest.hex();
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
  Report& report_;
  StageLog log_;
};

}  // namespace

void run_pipeline(const RunOptions& options, const StageContext& context, Report& report) {
  Pipeline(options, context, report).run();
}

}  // namespace stream_recon
