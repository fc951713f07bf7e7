// What a converter knows about its points and a reconstruction may use.
//
// Thread rule: a value.
#pragma once

#include <array>
#include <optional>
#include <string>

namespace stream_recon {

/// Distance between neighbouring samples along i, j and k of the grid that points were taken from,
/// in the units of the coordinates; each finite and > 0.
using SampleSpacing = std::array<double, 3>;

struct PointMetadata {
  std::optional<SampleSpacing> spacing;
  std::string source;  ///< the file or folder that was sampled
  std::string value;   ///< what was selected there, for people: "iso 100", "label 13"
};

}  // namespace stream_recon
