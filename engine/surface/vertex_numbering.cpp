#include "engine/surface/vertex_numbering.h"

#include <algorithm>

#include "engine/chunks/chunk_loop.h"
#include "engine/surface/chunk_facets.h"
#include "engine/surface/sheet_split.h"

namespace stream_recon {
namespace {

/// A facet's record and its share of the vertices, of the chunk's and of those of later chunks.
constexpr std::uint64_t kBytesAFacet = 40;
/// A spool's cursor.
constexpr std::uint64_t kFixedBytes = std::uint64_t{1} << 20;

template <class Record>
std::vector<Record> sorted_distinct(std::vector<Record> records) {
  std::sort(records.begin(), records.end());
  records.erase(std::unique(records.begin(), records.end()), records.end());
  return records;
}

}  // namespace

VertexNumbering::VertexNumbering(const ExportedFacets& surface, const SurfaceSheets* sheets,
                                 const StageContext& context)
    : sheets_(sheets),
      context_(context),
      memory_(context.budget.reserve(surface.layout().chunk_count() * sizeof first_numbers_[0],
                                     "numbers of vertices")),
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
    const std::uint64_t count =
        sheets_ != nullptr ? sheets_->border_count(owner) : surface.border_points().count(owner);
    const Reservation memory =
        context_.budget.reserve(count * sizeof(BorderPoint), "points at chunk borders");
    const auto uses = sorted_distinct(border_points(surface, owner));
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

std::vector<BorderPoint> VertexNumbering::border_points(const ExportedFacets& surface,
                                                        std::uint64_t owner) const {
  return sheets_ != nullptr ? sheets_->border_points(owner)
                            : surface.border_points().records(owner);
}

void VertexNumbering::hand_out(const ExportedFacets& surface, const ChunkSpool<Share>& shares) {
  const std::uint64_t chunks = surface.layout().chunk_count();
  std::uint64_t most = 0;
  for (std::uint64_t chunk = 0; chunk < chunks; ++chunk) {
    most = std::max(most, surface.facets().count(chunk));
  }
  first_numbers_.reserve(chunks);
  for_each_chunk(
      {.chunks = chunks,
       .at_once = chunks_at_once(most * kBytesAFacet + kFixedBytes, context_.budget),
       .takes_in_order = true},
      [&](std::uint64_t chunk) { return find_needs(chunk, surface, shares); },
      [this](std::uint64_t chunk, const ChunkNeeds& needs) { hand_out(chunk, needs); });
}

VertexNumbering::ChunkNeeds VertexNumbering::find_needs(std::uint64_t chunk,
                                                        const ExportedFacets& surface,
                                                        const ChunkSpool<Share>& shares) const {
  context_.stop.check();
  const std::uint64_t facet_bytes = surface.facets().count(chunk) * sizeof(FacetRecord);
  ChunkNeeds needs;
  needs.memory = context_.budget.reserve(
      facet_bytes, "numbering the vertices of a chunk (a smaller --chunk-points needs less)");
  {
    const ChunkLayout& layout = surface.layout();
    ChunkVertices points(layout.first_rank(chunk), layout.end_rank(chunk), context_.budget);
    add_vertices(surface.facets().records(chunk), points);
    needs.memory.resize(points.size() * sizeof(PointRank));
    needs.vertices = points.ranks();
  }
  if (sheets_ != nullptr) {
    // The corners and their keys; then keys in place of ranks.
    const Reservation memory = context_.budget.reserve(
        sheets_->corner_count(chunk) * (sizeof(SheetCorner) + 2 * sizeof(SheetKey)) +
            needs.vertices.size() * sizeof(SheetKey),
        "numbering the sheets of a chunk (a smaller --chunk-points needs less)");
    needs.vertices = split_vertices(needs.vertices, sheets_->corners(chunk));
    needs.memory.resize(needs.vertices.capacity() * sizeof(SheetKey));
  }
  needs.memory.resize(needs.memory.bytes() + shares.count(chunk) * sizeof(Share));
  needs.shares = sorted_distinct(shares.records(chunk));
  return needs;
}

void VertexNumbering::hand_out(std::uint64_t chunk, const ChunkNeeds& needs) {
  first_numbers_.push_back(vertex_count_);
  auto share = needs.shares.begin();
  for (const PointRank rank : needs.vertices) {
    share =
        std::find_if(share, needs.shares.end(), [rank](const Share& s) { return s.rank >= rank; });
    const auto end =
        std::find_if(share, needs.shares.end(), [rank](const Share& s) { return s.rank > rank; });
    const bool told = share != end && share->chunk == chunk;
    if (told) continue;
    const std::uint64_t number = vertex_count_++;
    for (; share != end; ++share) known_.append(share->chunk, {rank, number});
  }
}

std::vector<std::uint64_t> VertexNumbering::numbers_of(std::uint64_t chunk,
                                                       std::span<const PointRank> vertices) const {
  const Reservation memory = context_.budget.reserve(known_.count(chunk) * sizeof(Known),
                                                     "vertices known from earlier chunks");
  const auto known = sorted_distinct(known_.records(chunk));
  auto next_known = known.begin();
  std::uint64_t next_number = first_numbers_[chunk];
  std::vector<std::uint64_t> numbers;
  numbers.reserve(vertices.size());
  for (const PointRank rank : vertices) {
    while (next_known != known.end() && next_known->rank < rank) ++next_known;
    const bool is_known = next_known != known.end() && next_known->rank == rank;
    numbers.push_back(is_known ? next_known->number : next_number++);
  }
  return numbers;
}

}  // namespace stream_recon
