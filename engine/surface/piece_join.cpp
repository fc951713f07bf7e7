#include "engine/surface/piece_join.h"

#include <algorithm>
#include <array>
#include <utility>

#include "engine/order/external_sort.h"

namespace stream_recon {
namespace {

constexpr const char* kHolder = "the components of the surface";
constexpr const char* kSharedEdges = "shared_edges";
constexpr std::size_t kBlock = std::size_t{32} << 10;
constexpr std::uint64_t kMostSortMemory = std::uint64_t{32} << 20;

}  // namespace

PieceJoin::PieceJoin(const Options& options, const StageContext& context)
    : options_(options),
      context_(context),
      memory_(context.budget.reserve(options.layout.chunk_count() * sizeof(Chunk) + kWritingMemory,
                                     kHolder)),
      chunks_(options.layout.chunk_count()),
      writer_(create_records<SharedEdge>(context.scratch, kSharedEdges, kBlock)) {}

PieceJoin::~PieceJoin() {
  writer_.reset();
  context_.scratch.remove(kSharedEdges);
}

void PieceJoin::add(std::uint64_t chunk, const ChunkPieces& pieces, const ChunkSums& sums) {
  const std::uint64_t inner = pieces.count - pieces.reaching;
  Chunk& target = chunks_[chunk];
  target.sums = sums;
  target.reaching = pieces.reaching;
  if (options_.is_solid) {
    memory_.resize(memory_.bytes() + pieces.reaching * sizeof(PieceFacts));
    const auto first_inner = pieces.facts.begin() + pieces.reaching;
    target.facts.assign(pieces.facts.begin(), first_inner);
    std::for_each(first_inner, pieces.facts.end(), [this](const PieceFacts& p) { judge(p); });
  } else {
    joined_.components += inner;
  }
  writer_->append(pieces.told);
}

void PieceJoin::judge(const PieceFacts& piece) {
  const bool is_cavity = options_.is_solid && !piece.is_open && piece.volume.is_negative();
  ++(is_cavity ? joined_.cavities : joined_.components);
}

JoinedPieces PieceJoin::finish() {
  writer_->finish();
  writer_.reset();
  collect_facts();
  join_at_shared_edges();
  // Ascending, so that each sum has its terms in the order of the pieces.
  for (std::uint64_t piece = 0; piece < facts_.size(); ++piece) {
    PieceFacts& root = facts_[forest_->find(piece)];
    if (&root == &facts_[piece]) continue;
    root.volume = root.volume + facts_[piece].volume;
    root.is_open = root.is_open || facts_[piece].is_open;
  }
  for (std::uint64_t piece = 0; piece < reaching_; ++piece) {
    if (forest_->find(piece) != piece) continue;
    judge(options_.is_solid ? facts_[piece] : PieceFacts{});
  }
  return joined_;
}

void PieceJoin::collect_facts() {
  for (Chunk& chunk : chunks_) {
    joined_.area = joined_.area + chunk.sums.area;
    joined_.six_volumes = joined_.six_volumes + chunk.sums.six_volumes;
    reaching_ += std::exchange(chunk.reaching, reaching_);
  }
  const std::uint64_t fact_bytes = options_.is_solid ? sizeof(PieceFacts) : 0;
  memory_.resize(chunks_.size() * sizeof(Chunk) +
                 reaching_ * (2 * fact_bytes + sizeof(std::uint64_t)));
  if (options_.is_solid) facts_.reserve(reaching_);
  for (Chunk& chunk : chunks_) {
    facts_.insert(facts_.end(), chunk.facts.begin(), chunk.facts.end());
    chunk.facts = {};
  }
  memory_.resize(memory_.bytes() - reaching_ * fact_bytes);
  forest_.emplace(reaching_);
}

void PieceJoin::join_at_shared_edges() {
  ScratchReader<SharedEdge> reader(context_.scratch, kSharedEdges);
  if (reader.count() == 0) return;
  using Sort = ExternalSort<SharedEdge>;
  const std::uint64_t wanted =
      std::clamp(context_.budget.available() / 4, Sort::least_memory(), kMostSortMemory);
  Sort sort(context_, {kSharedEdges, wanted});
  {
    const Reservation memory = context_.budget.reserve(2 * record_cursor_memory(kBlock), kHolder);
    std::vector<SharedEdge> part(kBlock / sizeof(SharedEdge));
    while (const std::size_t count = reader.read(part)) {
      for (const SharedEdge& record : std::span(part).first(count)) sort.add(record);
    }
  }
  std::vector<SharedEdge> edge;
  sort.for_each([&](const SharedEdge& record) {
    if (!edge.empty() && !record.has_edge_of(edge.front())) {
      join_uses(edge);
      edge.clear();
    }
    edge.push_back(record);
  });
  join_uses(edge);
}

std::uint64_t PieceJoin::piece_of(const SharedEdge& use) const {
  return chunks_[options_.layout.chunk_of(use.lowest_corner())].reaching + use.piece();
}

void PieceJoin::join_uses(std::span<const SharedEdge> edge) {
  const auto first_wedge =
      std::find_if(edge.begin(), edge.end(), [](const SharedEdge& e) { return e.is_wedge(); });
  const auto uses = edge.first(static_cast<std::size_t>(first_wedge - edge.begin()));
  if (options_.is_solid) {
    join_wedges(uses, edge.subspan(uses.size()));
    return;
  }
  for (const SharedEdge& use : uses) forest_->join(piece_of(uses[0]), piece_of(use));
}

void PieceJoin::join_wedges(std::span<const SharedEdge> uses, std::span<const SharedEdge> wedges) {
  std::vector<bool> is_paired(uses.size(), false);
  const auto join = [&](std::size_t a, std::size_t b) {
    forest_->join(piece_of(uses[a]), piece_of(uses[b]));
    is_paired[a] = is_paired[b] = true;
  };
  const auto use_of = [&](PointRank apex) {
    return static_cast<std::size_t>(
        std::partition_point(uses.begin(), uses.end(),
                             [apex](const SharedEdge& use) { return use.apex < apex; }) -
        uses.begin());
  };
  if (uses.size() == 2 && uses[0].rises() != uses[1].rises()) join(0, 1);
  for (const SharedEdge& wedge : wedges) join(use_of(wedge.apex), use_of(wedge.other_apex()));
  for (std::size_t i = 0; i < uses.size(); ++i) {
    if (!is_paired[i]) facts_[piece_of(uses[i])].is_open = true;
  }
}

}  // namespace stream_recon
