// Makes the parts of a framed point stream (io/pts_layout.h).
//
// Guarantees: header(), any number of frame()s and end(), one after the other, are a valid stream.
// Bytes are a function of the metadata and of the points of each frame.
// Memory: one frame. Thread rule: one writer.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "io/coordinates.h"
#include "io/point_metadata.h"
#include "spatial/point.h"

namespace stream_recon {

class PtsEncoder {
 public:
  /// kFloat32 rounds coordinates to nearest.
  explicit PtsEncoder(Scalar scalar) : scalar_(scalar) {}

  std::string header(const PointMetadata& metadata) const;
  /// \pre 1 to kPtsMaxFramePoints points
  std::string frame(std::span<const Point3> points);
  std::string end() const;

 private:
  Scalar scalar_;
  std::uint64_t points_ = 0;
};

}  // namespace stream_recon
