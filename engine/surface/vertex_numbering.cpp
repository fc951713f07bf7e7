#include "engine/surface/vertex_numbering.h"

#include <algorithm>

#include "engine/surface/chunk_facets.h"

namespace stream_recon {
namespace {

template <class Record>
std::vector<Record> sorted_distinct(std::vector<Record> records) {
  std::sort(records.begin(), records.end());
  records.erase(std::unique(records.begin(), records.end()), records.end());
  return records;
}

}  // namespace

VertexNumbering::VertexNumbering(const ExportedFacets& surface, const StageContext& context)
    : context_(context),
      known_("vertex_numbers", surface.layout().chunk_count(),
             {&context.scratch, &context.budget}) {
  ChunkSpool<Share> shares("shared_vertices", surface.layout().chunk_count(),
                           {&context.scratch, &context.budget});
  find_shares(surface, shares);
  shares.finish();
  hand_out(surface, shares);
  known_.finish();
}

/// A point used by chunks u1 < u2 < ... and owned by a later one, c, appears first in u1, which
/// must tell u2, ... and c; these must know that they are told.
void VertexNumbering::find_shares(const ExportedFacets& surface, ChunkSpool<Share>& shares) {
  for (std::uint64_t owner = 0; owner < surface.layout().chunk_count(); ++owner) {
    context_.stop.check();
    const Reservation memory = context_.budget.reserve(
        surface.border_points().count(owner) * sizeof(BorderPoint), "points at chunk borders");
    const auto uses = sorted_distinct(surface.border_points().records(owner));
    for (std::size_t i = 0; i < uses.size();) {
      const PointRank rank = uses[i].rank;
      const std::uint64_t first = uses[i].user;
      const auto tell = [&](std::uint64_t chunk) {
        shares.append(first, {rank, chunk});
        shares.append(chunk, {rank, chunk});
      };
      for (++i; i < uses.size() && uses[i].rank == rank; ++i) tell(uses[i].user);
      tell(owner);
    }
  }
}

void VertexNumbering::hand_out(const ExportedFacets& surface, const ChunkSpool<Share>& shares) {
  for (std::uint64_t chunk = 0; chunk < surface.layout().chunk_count(); ++chunk) {
    context_.stop.check();
    const std::uint64_t facets = surface.facets().count(chunk);
    if (facets == 0) continue;
    const Reservation memory = context_.budget.reserve(
        facets * (sizeof(FacetRecord) + 3 * sizeof(PointRank)) +
            shares.count(chunk) * sizeof(Share),
        "numbering the vertices of a chunk (a smaller --chunk-points needs less)");
    const auto chunk_shares = sorted_distinct(shares.records(chunk));
    auto share = chunk_shares.begin();
    for (const PointRank rank : vertex_ranks(surface.facets().records(chunk))) {
      share = std::find_if(share, chunk_shares.end(),
                           [rank](const Share& s) { return s.rank >= rank; });
      const auto end =
          std::find_if(share, chunk_shares.end(), [rank](const Share& s) { return s.rank > rank; });
      const bool told = share != end && share->chunk == chunk;
      if (told) continue;
      const std::uint64_t number = vertex_count_++;
      for (; share != end; ++share) known_.append(share->chunk, {rank, number});
    }
  }
}

std::vector<std::uint64_t> VertexNumbering::numbers_of(std::uint64_t chunk,
                                                       std::span<const PointRank> vertices) {
  const Reservation memory = context_.budget.reserve(known_.count(chunk) * sizeof(Known),
                                                     "vertices known from earlier chunks");
  const auto known = sorted_distinct(known_.records(chunk));
  auto next_known = known.begin();
  std::vector<std::uint64_t> numbers;
  numbers.reserve(vertices.size());
  for (const PointRank rank : vertices) {
    while (next_known != known.end() && next_known->rank < rank) ++next_known;
    const bool is_known = next_known != known.end() && next_known->rank == rank;
    numbers.push_back(is_known ? next_known->number : next_number_++);
  }
  return numbers;
}

}  // namespace stream_recon
