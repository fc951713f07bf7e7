#include "engine/crust/crust_assembly.h"

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <tuple>
#include <vector>

#include "engine/crust/crust_records.h"
#include "engine/each_record.h"
#include "engine/order/external_sort.h"
#include "engine/order/point_store.h"
#include "engine/surface/facet_export.h"
#include "io/error.h"

namespace stream_recon {
namespace {

/// Where a vertex of a window is in the store.
struct VertexRank {
  std::uint32_t window;
  std::uint32_t position;
  std::uint32_t rank;

  friend bool operator<(const VertexRank& a, const VertexRank& b) {
    return std::tie(a.window, a.position) < std::tie(b.window, b.position);
  }
};

FacetRecord facet_of(const CrustTriangle& triangle, std::span<const std::uint32_t> ranks) {
  std::array<std::uint32_t, 3> r{ranks[triangle.corners[0]], ranks[triangle.corners[1]],
                                 ranks[triangle.corners[2]]};
  std::rotate(r.begin(), std::min_element(r.begin(), r.end()), r.end());
  const bool ascends = r[1] < r[2];
  if (!ascends) std::swap(r[1], r[2]);
  return {.ranks = {r[0], r[1], r[2]},
          .delta = triangle.delta,
          .source = TriangleSource::kCrust,
          .facing = ascends ? Facing::kOutward : Facing::kInward};
}

class CrustAssembly {
 public:
  CrustAssembly(const CrustWindows& windows, const CrustAssemblyOptions& options,
                const StageContext& context)
      : windows_(windows), options_(options), context_(context) {}

  CrustFacts run() {
    const std::uint64_t share =
        std::max(context_.budget.available() * 2 / 5, ExternalSort<CrustVertex>::least_memory());
    ExternalSort<VertexRank> ranks(context_, {"crust corners", share});
    {
      ExternalSort<CrustVertex> vertices(context_, {"crust vertices", share});
      gather(vertices);
      store(vertices, ranks);
    }
    make_facets(ranks);
    return facts_;
  }

 private:
  template <class Record, class Take>
  void read_all(const std::string& name, const Take& take) {
    for_each_batch<Record>(context_, name, take);
    context_.scratch.remove(name);
  }

  void gather(ExternalSort<CrustVertex>& vertices) {
    for (const CrustWindow& window : windows_.windows) {
      if (window.vertices == 0) continue;
      read_all<CrustVertex>(window.vertices_file(), [&](std::span<const CrustVertex> some) {
        for (const CrustVertex& vertex : some) vertices.add(vertex);
      });
    }
  }

  void store(ExternalSort<CrustVertex>& vertices, ExternalSort<VertexRank>& ranks) {
    PointStoreReader samples(context_.scratch, kPointStore);
    auto points = create_records<StoredPoint>(context_.scratch, kCrustPoints, kPointStoreBlock);
    std::optional<CrustVertexName> last;
    vertices.for_each([&](const CrustVertex& vertex) {
      if (last != vertex.name) {
        if (facts_.vertices == std::numeric_limits<std::uint32_t>::max()) {
          throw InputError("the crust has more than 4294967295 vertices; split the cloud");
        }
        const StoredPoint stored = stored_point(vertex, samples);
        facts_.range.extend(stored.point);
        points.append(stored);
        ++facts_.vertices;
        last = vertex.name;
      }
      ranks.add({vertex.window, vertex.position, static_cast<std::uint32_t>(facts_.vertices - 1)});
    });
    points.finish();
  }

  StoredPoint stored_point(const CrustVertex& vertex, PointStoreReader& samples) {
    const bool is_sample = vertex.name.is_sample();
    const std::uint64_t new_index = options_.input_points + facts_.vertices - facts_.samples;
    if (!is_sample && vertex.is_astray == 0) return {vertex.point, new_index};
    StoredPoint sample;
    samples.read_at(vertex.name.sample, std::span(&sample, 1));
    if (!is_sample) return {sample.point, new_index};
    ++facts_.samples;
    return sample;
  }

  void make_facets(ExternalSort<VertexRank>& sorted) {
    const SolidExportOptions options{{options_.chunk_points, facts_.vertices}, {}};
    std::vector<std::uint32_t> ranks;
    sorted.for_each([&](const VertexRank& vertex) {
      ranks.push_back(vertex.rank);
      const CrustWindow& window = windows_.windows[vertex.window];
      if (ranks.size() < window.vertices) return;
      export_window(window, ranks, options);
      ranks.clear();
    });
  }

  void export_window(const CrustWindow& window, std::span<const std::uint32_t> ranks,
                     const SolidExportOptions& options) {
    ExportWriter out(context_.scratch, window.first_rank, kCrustPrefix);
    std::vector<FacetRecord> facets;
    read_all<CrustTriangle>(window.triangles_file(), [&](std::span<const CrustTriangle> some) {
      facets.clear();
      for (const CrustTriangle& triangle : some) facets.push_back(facet_of(triangle, ranks));
      export_solid_facets(facets, options, out);
    });
    out.finish();
  }

  const CrustWindows& windows_;
  const CrustAssemblyOptions& options_;
  const StageContext& context_;
  CrustFacts facts_;
};

}  // namespace

CrustFacts assemble_crust(const CrustWindows& windows, const CrustAssemblyOptions& options,
                          const StageContext& context) {
  return CrustAssembly(windows, options, context).run();
}

}  // namespace stream_recon
