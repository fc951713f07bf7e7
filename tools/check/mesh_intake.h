// Takes a mesh in, triangle by triangle: measures each, and hands it to what sorts and counts.
//
// Thread rule: one thread. Memory: TriangleBatch::memory_bytes().
#pragma once

#include <string>

#include "engine/order/external_sort.h"
#include "io/mesh_source.h"
#include "tools/check/compensated_sum.h"
#include "tools/check/component_census.h"
#include "tools/check/component_labels.h"
#include "tools/check/triangle_batch.h"
#include "tools/check/vertex_copies.h"
#include "tools/check/vertex_star.h"

namespace stream_recon {

class MeshIntake final : public MeshVisitor {
 public:
  /// Where everything goes; all outlive the intake.
  struct Parts {
    const std::string& path;
    const StageContext& context;
    ComponentLabels& labels;
    ComponentCensus& census;
    ExternalSort<StarRecord>& stars;
    VertexCopies& copies;
    MeshFacts& facts;
  };

  explicit MeshIntake(const Parts& parts) : to_(parts) {}

  /// \throw InputError not finite; IoError, BudgetError, Interrupted; so for all
  void vertex(std::uint64_t number, const Point3& point) override;
  void triangle(const MeshTriangle& corners, const std::array<Point3, 3>& points) override;
  /// No more triangles.
  void finish();

 private:
  void flush();
  void add_star(const TriangleBatch::Entry& entry, std::size_t corner, ComponentLabel label);

  Parts to_;
  TriangleBatch batch_;
  CompensatedSum area_;
  Point3 origin_;  ///< of volumes: the first corner
};

}  // namespace stream_recon
