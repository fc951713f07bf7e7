// What the incremental kernel asks about a site and a cell, for points and for weighted points:
// one set of names, so that the rest of the kernel is written once.
//
// Guarantees: exact answers, ties decided (predicates.h); positive is in conflict. Thread rule:
// const.
#pragma once

#include "spatial/cell_array.h"
#include "spatial/power_batch.h"
#include "spatial/predicates.h"
#include "spatial/site.h"
#include "spatial/sphere_batch.h"

namespace stream_recon::detail {

/// The sites at the corners of a cell; the last one is meaningless for an infinite cell.
template <class Site>
struct CellSites {
  const Site& a;
  const Site& b;
  const Site& c;
  const Site& d;

  CellSites(const Cell& cell, const Site* sites)
      : a(sites[vertex_of(cell, 0)]),
        b(sites[cell.vertex[1]]),
        c(sites[cell.vertex[2]]),
        d(sites[cell.vertex[3]]) {}
};

/// side(): of the sphere of a finite cell. side_in_plane(): of the circle of a hull facet, for a
/// query in its plane. tie(): side() where a batch found a cell exactly on the sphere.
template <class Site>
struct SiteTests;

template <>
struct SiteTests<Point3> {
  /// Whether a site may be no vertex of the triangulation.
  static constexpr bool kMayHide = false;
  using Query = PaddedPoint;
  using BatchTest = SphereBatchTest;
  using Corners = CellSites<Point3>;

  static BatchTest select_batch_test() { return select_sphere_batch_test(); }
  static int side(const Predicates& exact, const Corners& p, const Point3& query) {
    return exact.in_sphere_perturbed(p.a, p.b, p.c, p.d, query);
  }
  static int side_in_plane(const Predicates& exact, const Corners& p, const Point3& query) {
    return exact.in_circle_perturbed(p.a, p.b, p.c, query);
  }
  static int tie(const Predicates& exact, const Corners& p, const Point3& query) {
    return exact.in_sphere_tie(p.a, p.b, p.c, p.d, query);
  }
};

template <>
struct SiteTests<WeightedPoint3> {
  static constexpr bool kMayHide = true;
  using Query = WeightedPoint3;
  using BatchTest = PowerBatchTest;
  using Corners = CellSites<WeightedPoint3>;

  static BatchTest select_batch_test() { return select_power_batch_test(); }
  static int side(const Predicates& exact, const Corners& p, const WeightedPoint3& query) {
    return exact.power_test_perturbed(p.a, p.b, p.c, p.d, query);
  }
  static int side_in_plane(const Predicates& exact, const Corners& p, const WeightedPoint3& query) {
    return exact.power_circle_perturbed(p.a, p.b, p.c, query);
  }
  static int tie(const Predicates& exact, const Corners& p, const WeightedPoint3& query) {
    return exact.in_sphere_tie(p.a.point, p.b.point, p.c.point, p.d.point, query.point);
  }
};

}  // namespace stream_recon::detail
