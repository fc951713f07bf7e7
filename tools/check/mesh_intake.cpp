#include "tools/check/mesh_intake.h"

#include <fmt/format.h>

#include <vector>

#include "io/error.h"
#include "tools/check/triangle_shape.h"

namespace stream_recon {

void MeshIntake::vertex(std::uint64_t number, const Point3& point) {
  if (!is_finite(point)) {
    throw InputError(fmt::format("{}: vertex {} has a coordinate that is not finite; correct it",
                                 to_.path, number));
  }
  to_.copies.add(number, point);
}

void MeshIntake::triangle(const MeshTriangle& corners, const std::array<Point3, 3>& points) {
  MeshFacts& facts = to_.facts;
  if (facts.triangles++ == 0) origin_ = points[0];
  for (const Point3& point : points) facts.box.extend(point);
  if (is_flat(points)) ++facts.zero_area_triangles;
  area_.add(area(points));
  const auto [a, b, c] = corners;
  if (a == b || b == c || c == a) {
    ++facts.repeated_corner_triangles;
    return;
  }
  batch_.add(corners, signed_volume(points, origin_));
  if (batch_.is_full()) flush();
}

void MeshIntake::finish() {
  flush();
  to_.facts.area = area_.value();
}

void MeshIntake::flush() {
  to_.context.stop.check();
  std::vector<ComponentLabel> labels(batch_.number_pieces());
  for (ComponentLabel& label : labels) label = to_.labels.create();
  for (const TriangleBatch::Entry& entry : batch_.entries()) {
    const ComponentLabel label = labels[entry.piece];
    to_.census.add_triangle(label, entry.volume);
    for (std::size_t corner = 0; corner < 3; ++corner) add_star(entry, corner, label);
  }
  batch_.clear();
}

void MeshIntake::add_star(const TriangleBatch::Entry& entry, std::size_t corner,
                          ComponentLabel label) {
  const std::uint64_t next = entry.corners[(corner + 1) % 3];
  const std::uint64_t last = entry.corners[(corner + 2) % 3];
  const bool is_reversed = last < next;
  to_.stars.add({entry.corners[corner], is_reversed ? last : next, is_reversed ? next : last, label,
                 is_reversed ? 1U : 0U});
}

}  // namespace stream_recon
