#include "tools/check/component_census.h"

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "tools/check/compensated_sum.h"

namespace stream_recon {
namespace {

constexpr const char* kTriangleNotes = "triangle_notes";
constexpr const char* kVertexNotes = "vertex_notes";

struct Component {
  std::uint64_t triangles = 0;
  std::int64_t euler = 0;
  CompensatedSum volume;
  std::uint32_t faults = 0;
};
static_assert(sizeof(Component) <= 48);

/// Calls take(record) for each record of a file, then removes it.
template <class Record, class Take>
void take_all(const StageContext& context, const std::string& name, const Take& take) {
  {
    ScratchReader<Record> reader(context.scratch, name);
    std::vector<Record> batch(4096);
    while (const std::size_t got = reader.read(batch)) {
      context.stop.check();
      for (const Record& record : std::span(batch).first(got)) take(record);
    }
  }
  context.scratch.remove(name);
}

void judge(const Component& component, MeshFacts& facts, CompensatedSum& volume, bool& has_volume) {
  const bool is_closed = (component.faults & kHasBoundary) == 0;
  const bool is_manifold = (component.faults & kIsNonmanifold) == 0;
  const bool is_oriented = (component.faults & kIsWronglyOriented) == 0;
  if (is_closed) ++facts.closed_components;
  if (is_manifold) ++facts.manifold_components;
  if (is_oriented) ++facts.oriented_components;
  if (is_closed && is_manifold && is_oriented) {
    ++facts.components_by_genus[(2 - component.euler) / 2];
  }
  facts.largest_component_triangles =
      std::max(facts.largest_component_triangles, component.triangles);
  if ((component.faults & kIsUnbalanced) == 0) {
    volume.add(component.volume.value());
    has_volume = true;
  }
}

}  // namespace

ComponentCensus::ComponentCensus(const StageContext& context)
    : context_(context),
      triangles_(create_records<TriangleNote>(context.scratch, kTriangleNotes, kBlock)),
      vertices_(create_records<VertexNote>(context.scratch, kVertexNotes, kBlock)) {}

void ComponentCensus::finish(ComponentLabels& labels, MeshFacts& facts) {
  triangles_.finish();
  vertices_.finish();
  facts.components = labels.resolve();
  const Reservation memory =
      context_.budget.reserve(facts.components * sizeof(Component), "the counts of components");
  std::vector<Component> components(facts.components);
  take_all<TriangleNote>(context_, kTriangleNotes, [&](const TriangleNote& note) {
    Component& component = components[labels.number_of(note.label)];
    ++component.triangles;
    ++component.euler;
    component.volume.add(note.volume);
  });
  take_all<VertexNote>(context_, kVertexNotes, [&](const VertexNote& note) {
    Component& component = components[labels.number_of(note.label)];
    component.euler += 1 - static_cast<std::int64_t>(note.edges);
    component.faults |= note.faults;
  });
  CompensatedSum volume;
  bool has_volume = false;
  for (const Component& component : components) judge(component, facts, volume, has_volume);
  if (has_volume) facts.volume = volume.value();
}

}  // namespace stream_recon
