// From which side a mesh is looked at, without perspective.
//
// The axes are right-handed: x to the right, y away from the viewer, z up for the front view. In
// ITK's space (x to the patient's left, y backwards, z up) the front view is the patient's face.
// Thread rule: a value.
#pragma once

#include <string>
#include <vector>

#include "spatial/point.h"

namespace stream_recon {

struct View {
  Point3 right{1, 0, 0};
  Point3 up{0, 0, 1};
  Point3 toward{0, -1, 0};  ///< to the viewer

  /// Coordinates along right, up and toward.
  Point3 operator()(const Point3& p) const;
};

/// front, back, left, right (the mesh's own), top, bottom, or "azimuth,elevation" in degrees: the
/// viewer walks from the front to the mesh's left, then climbs; -90 <= elevation <= 90.
/// \throw std::invalid_argument
View parse_view(const std::string& text);

struct NamedView {
  std::string name = "front";
  View view;
};

/// Views separated by commas: "front,left,top"; two numbers in a row are angles.
/// \throw std::invalid_argument
std::vector<NamedView> parse_views(const std::string& text);

}  // namespace stream_recon
