#include "engine/labels/part_join.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "engine/labels/signed_forest.h"
#include "engine/node_set.h"
#include "engine/order/stream_merger.h"
#include "io/error.h"

namespace stream_recon {
namespace {

/// Of a stream, read at once.
constexpr std::size_t kBatchBytes = std::size_t{32} << 10;
/// Records between two looks at the stop request.
constexpr std::uint64_t kStretch = 1 << 13;
/// Edges that are looked up together.
constexpr std::size_t kBlock = 32;

struct ComesBefore {
  bool operator()(const EvidenceEdge& x, const EvidenceEdge& y) const { return comes_before(x, y); }
};

class PartJoin {
 public:
  PartJoin(const EvidenceSource& source, std::span<const EvidencePart> parts,
           const StageContext& context)
      : source_(source), parts_(parts), context_(context), starts_{0} {
    for (const EvidencePart& part : parts) starts_.push_back(starts_.back() + part.nodes);
  }

  JoinedParts run(const std::string& name) {
    joined_.part = {
        .first_rank = parts_.front().first_rank, .end_rank = parts_.back().end_rank, .name = name};
    const NodeSet border = join_nodes();
    const auto attachments = join_edges(border);
    write_attachments(border, attachments);
    return std::move(joined_);
  }

 private:
  template <class Record>
  auto open() const {
    std::vector<std::unique_ptr<EvidenceStream<Record>>> streams;
    for (const EvidencePart& part : parts_) {
      streams.push_back(std::make_unique<EvidenceStream<Record>>(source_, part));
    }
    return streams;
  }

  template <class Record>
  RecordWriter<Record> create(const std::string& name) const {
    return create_records<Record>(context_.scratch, name, kEvidenceBlock);
  }

  /// Called once a record.
  void advance() {
    if (++done_ % kStretch != 0) return;
    context_.stop.check();
    context_.progress.advance(kStretch);
  }

  [[noreturn]] void fail() const {
    throw IoError("what windows from rank " + std::to_string(joined_.part.first_rank) +
                  " on have handed on of evidence is damaged; start again without --resume");
  }

  bool is_border(const NodeKey& key) const {
    return key == kInfiniteNode || key.ranks.front() < joined_.part.first_rank ||
           key.ranks.back() >= joined_.part.end_rank;
  }

  NodeSet join_nodes();
  std::vector<Attachment> join_edges(const NodeSet& border);
  void write_attachments(const NodeSet& border, const std::vector<Attachment>& attachments) const;
  /// Where the numbers of an edge's nodes are.
  struct Ends {
    const std::uint32_t* a;
    const std::uint32_t* b;
  };
  Ends ends_of(const EvidenceEdge& edge, std::size_t part) const;

  const EvidenceSource& source_;
  std::span<const EvidencePart> parts_;
  const StageContext& context_;
  std::vector<std::uint64_t> starts_;   ///< of each part in numbers_, and the end
  std::vector<std::uint32_t> numbers_;  ///< among all nodes, of each part's nodes
  JoinedParts joined_;
  std::uint64_t done_ = 0;
};

/// Numbers the nodes of all parts by their keys and writes those that are border.
NodeSet PartJoin::join_nodes() {
  numbers_.resize(starts_.back());
  auto next = std::vector<std::uint64_t>(starts_.begin(), starts_.end() - 1);
  NodeSet border(static_cast<std::uint32_t>(starts_.back()));
  auto writer = create<NodeKey>(joined_.part.nodes_file());
  StreamMerger<NodeKey, EvidenceStream<NodeKey>> merger(open<NodeKey>(),
                                                        kBatchBytes / sizeof(NodeKey));
  std::uint32_t count = 0;
  NodeKey last;
  NodeKey key;
  while (const auto part = merger.next(key)) {
    if (count == 0 || key != last) {
      if (count != 0 && key < last) fail();
      if (is_border(key)) {
        border.insert(count);
        writer.append(key);
      }
      last = key;
      ++count;
    }
    if (next[*part] == starts_[*part + 1]) fail();
    numbers_[next[*part]++] = count - 1;
    advance();
  }
  if (!std::equal(next.begin(), next.end(), starts_.begin() + 1)) fail();
  writer.finish();
  border.shrink(count);
  border.number();
  joined_.part.nodes = border.count();
  joined_.contracted = count - border.count();
  return border;
}

/// \throw IoError there are no such nodes
PartJoin::Ends PartJoin::ends_of(const EvidenceEdge& edge, std::size_t part) const {
  if (edge.a >= parts_[part].nodes || edge.b >= parts_[part].nodes) fail();
  return {&numbers_[starts_[part] + edge.a], &numbers_[starts_[part] + edge.b]};
}

/// Writes the edges that are left. \return What each of all nodes hangs on
// In the order of their weights, edges lie anywhere among the nodes. So what a block of them asks
// for is on its way before the first is taken.
std::vector<Attachment> PartJoin::join_edges(const NodeSet& border) {
  SignedForest forest(border);
  auto writer = create<EvidenceEdge>(joined_.part.edges_file());
  StreamMerger<EvidenceEdge, EvidenceStream<EvidenceEdge>, ComesBefore> merger(
      open<EvidenceEdge>(), kBatchBytes / sizeof(EvidenceEdge));
  std::array<EvidenceEdge, kBlock> edges;
  std::array<Ends, kBlock> ends;
  std::optional<EvidenceEdge> last;
  for (std::size_t count = kBlock; count == kBlock;) {
    for (count = 0; count < kBlock; ++count) {
      EvidenceEdge& edge = edges[count];
      const auto part = merger.next(edge);
      if (!part) break;
      if (!std::isfinite(edge.weight) || edge.weight < 0 || (last && !comes_before(*last, edge))) {
        fail();
      }
      last = edge;
      ends[count] = ends_of(edge, *part);
      __builtin_prefetch(ends[count].a);
      __builtin_prefetch(ends[count].b);
    }
    for (std::size_t i = 0; i < count; ++i) {
      edges[i].a = *ends[i].a;
      edges[i].b = *ends[i].b;
      forest.prefetch(edges[i]);
    }
    for (const EvidenceEdge& edge : std::span(edges).first(count)) {
      if (auto left = forest.add(edge)) {
        left->a = border.position(left->a);
        left->b = border.position(left->b);
        writer.append(*left);
      }
      advance();
    }
  }
  writer.finish();
  joined_.part.edges = writer.record_count();
  return std::move(forest).attachments();
}

void PartJoin::write_attachments(const NodeSet& border,
                                 const std::vector<Attachment>& attachments) const {
  auto writer = create<Attachment>(attachments_file(joined_.part));
  for (const std::uint32_t number : numbers_) {
    Attachment attachment = attachments[number];
    if (attachment.is_attached) attachment.node = border.position(attachment.node);
    writer.append(attachment);
  }
  writer.finish();
}

}  // namespace

std::uint64_t join_memory(const JoinSize& size) {
  const std::uint64_t streams = size.parts * (evidence_stream_memory() + kBatchBytes);
  const std::uint64_t nodes = size.nodes * sizeof(std::uint32_t) + NodeSet::memory(size.nodes) +
                              SignedForest::memory(size.nodes);
  return streams + record_file_memory(kEvidenceBlock) + nodes;
}

JoinedParts join_parts(const EvidenceSource& source, std::span<const EvidencePart> parts,
                       const std::string& name, const StageContext& context) {
  JoinSize size;
  for (const EvidencePart& part : parts) size.add(part);
  const Reservation memory =
      context.budget.reserve(join_memory(size), "joining the evidence of neighbouring windows");
  return PartJoin(source, parts, context).run(name);
}

}  // namespace stream_recon
