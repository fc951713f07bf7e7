#include "tools/check/star_census.h"

#include <vector>

#include "tools/check/boundary_rings.h"

namespace stream_recon {
namespace {

class StarCensus {
 public:
  explicit StarCensus(const StarCensusParts& parts)
      : to_(parts),
        rings_(parts.context.budget),
        memory_(parts.context.budget.reserve(0, "the largest star of a vertex")) {}

  void take(const StarRecord& record) {
    if (!records_.empty() && record.vertex != records_.front().vertex) finish_star();
    if (records_.size() == most_) grow();
    records_.push_back(record);
  }

  void finish() {
    if (!records_.empty()) finish_star();
    const BoundaryRings::Counts rings = rings_.count();
    to_.facts.boundary_rings = rings.rings;
    to_.facts.simple_boundary_rings = rings.simple;
  }

 private:
  /// Bytes a record: itself, and what VertexStar makes of it.
  static constexpr std::uint64_t kRecordBytes = 2 * (sizeof(StarRecord) + 68);

  void grow() {
    most_ = std::max<std::size_t>(1024, 2 * most_);
    memory_.resize(most_ * kRecordBytes);
    records_.reserve(most_);
  }

  void finish_star() {
    star_.take(records_);
    MeshFacts& facts = to_.facts;
    VertexNote note{records_.front().label};
    for (const StarRecord& record : records_) to_.labels.join(note.label, record.label);
    ++facts.vertices;
    facts.duplicate_triangles += star_.duplicates();
    if (!star_.is_fan()) {
      ++facts.nonmanifold_vertices;
      note.faults |= kIsNonmanifold;
    }
    const std::uint64_t vertex = records_.front().vertex;
    for (const StarEdge& edge : star_.edges()) {
      if (edge.other > vertex) count(edge, note);
    }
    rings_.add(vertex, star_.edges());
    to_.census.add_vertex(note);
    records_.clear();
  }

  void count(const StarEdge& edge, VertexNote& note) {
    MeshFacts& facts = to_.facts;
    const auto count_if = [&note](bool holds, std::uint64_t& counter, ComponentFault fault) {
      if (!holds) return;
      ++counter;
      note.faults |= fault;
    };
    ++facts.edges;
    ++note.edges;
    count_if(edge.is_boundary(), facts.boundary_edges, kHasBoundary);
    count_if(edge.is_nonmanifold(), facts.nonmanifold_edges, kIsNonmanifold);
    count_if(edge.is_wrongly_oriented(), facts.wrongly_oriented_edges, kIsWronglyOriented);
    if (!edge.is_balanced()) note.faults |= kIsUnbalanced;
  }

  StarCensusParts to_;
  BoundaryRings rings_;
  Reservation memory_;
  std::vector<StarRecord> records_;
  std::size_t most_ = 0;
  VertexStar star_;
};

}  // namespace

void count_stars(ExternalSort<StarRecord>& stars, const StarCensusParts& parts) {
  StarCensus census(parts);
  stars.for_each([&census](const StarRecord& record) { census.take(record); });
  census.finish();
}

}  // namespace stream_recon
