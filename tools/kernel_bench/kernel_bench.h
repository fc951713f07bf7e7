// Times the in-core Delaunay tetrahedralization of a cloud, or the regular triangulation of its
// poles.
//
// Guarantees: what is timed is Hilbert keys, sort and insertion, in this thread; reading, removal
// of duplicates and the digest are not. Memory: the cloud twice, its keys and the kernel.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "io/point_source.h"
#include "spatial/box.h"
#include "spatial/point.h"

namespace stream_recon {

/// A cloud without duplicates; each point is named by the lowest index it has in the input.
struct DistinctPoints {
  std::vector<Point3> points;          ///< in input order
  std::vector<std::uint64_t> indices;  ///< input index of each
  std::uint64_t duplicates = 0;
};

/// Reads a source to its end.
/// \throw InputError non-finite point; what the source throws
DistinctPoints read_distinct_points(PointSource& source);

struct KernelTimes {
  double sort_seconds = 0;    ///< keys and sort
  double insert_seconds = 0;  ///< copy in order and insertion
  double cpu_seconds = 0;     ///< of the processor for both; other work beside does not count
  std::uint64_t points = 0;
  std::uint64_t hidden = 0;      ///< poles without a power cell
  std::uint64_t tetrahedra = 0;  ///< finite
  std::uint64_t kernel_bytes = 0;
  int dimension = -1;  ///< below 3 there are no tetrahedra
  std::string digest;  ///< of the tetrahedra's input indices (spatial/simplex_digest.h)

  double seconds() const { return sort_seconds + insert_seconds; }
};

/// \throw InputError coordinates too far apart in magnitude
KernelTimes time_kernel(const DistinctPoints& cloud);

/// Poles of a cloud (pole_sites.h) by ascending place, and the box of its points.
struct PoleCloud {
  std::vector<WeightedPoint3> sites;
  Box3 box;
};

/// \throw InputError coordinates too far apart in magnitude
PoleCloud find_poles(const DistinctPoints& cloud);

/// Times the regular triangulation of poles, sorted along the curve that fills the box. The digest
/// names a pole by its position. \throw InputError coordinates too far apart in magnitude
KernelTimes time_regular_kernel(const PoleCloud& poles);

}  // namespace stream_recon
