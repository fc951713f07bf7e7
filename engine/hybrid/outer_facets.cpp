#include "engine/hybrid/outer_facets.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/hybrid/hole_records.h"
#include "engine/order/external_sort.h"
#include "engine/surface/facet_record.h"
#include "engine/windows/export_reader.h"

namespace stream_recon {
namespace {

/// Those with two of the corners, ascending, more than once where they have three.
void holes_beside(const FacetRecord& facet, const HoleSamples& samples,
                  std::vector<std::uint32_t>& holes) {
  holes.clear();
  for (const PointRank rank : facet.ranks) {
    for (const HoleSample& at : samples.of(static_cast<std::uint32_t>(rank))) {
      holes.push_back(at.hole);
    }
  }
  std::sort(holes.begin(), holes.end());
}

}  // namespace

void store_outer_facets(const HoleSamples& samples, SampleChoice& beside,
                        const StageContext& context) {
  const std::uint64_t share = context.budget.available() * 2 / 5;
  ExternalSort<OuterFacet> sorted(
      context, {"facets at holes", std::max(share, ExternalSort<OuterFacet>::least_memory())});
  {
    const ExportReader exports(context.scratch, context.budget, kLabelledPrefix);
    std::vector<std::uint32_t> holes;
    const auto visit = [&](std::span<const FacetRecord> facets) {
      context.stop.check();
      for (const FacetRecord& facet : facets) {
        holes_beside(facet, samples, holes);
        for (std::size_t i = 1; i < holes.size(); ++i) {
          const bool is_new = i == 1 || holes[i] != holes[i - 2];
          if (holes[i] != holes[i - 1] || !is_new) continue;
          sorted.add({holes[i], ranks_of(facet)});
          for (const std::uint32_t rank : ranks_of(facet)) beside.choose(rank);
        }
      }
    };
    for (const std::uint64_t chunk : exports.chunks(ExportKind::kFacets)) {
      exports.visit<FacetRecord>(ExportKind::kFacets, chunk, visit);
    }
  }
  auto out = create_records<OuterFacet>(context.scratch, kOuterFacets, kHoleBlock);
  sorted.for_each([&](const OuterFacet& facet) { out.append(facet); });
  out.finish();
}

}  // namespace stream_recon
