// A stream of points from a file or pipe, whatever its format.
//
// Guarantees: every point of the input is delivered once, in input order, with its exact value (a
// float is widened); memory is a fixed buffer whatever the input's size; nothing is seeked, so a
// pipe will do. A truncated or malformed input throws InputError with file and byte or line; it
// never ends early in silence. Non-finite points are delivered: rejecting them is the run's affair.
// Thread rule: one reader.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "io/point_metadata.h"
#include "spatial/point.h"

namespace stream_recon {

enum class InputFormat { kAuto, kPly, kXyz, kF32, kF64, kVtk, kVtp, kPts };

/// What people call them, in the order of the enumeration.
inline constexpr std::array kInputFormatNames{"auto", "ply", "xyz", "f32",
                                              "f64",  "vtk", "vtp", "pts"};

class PointSource {
 public:
  virtual ~PointSource() = default;

  /// Fills the front of `out`; the number of points delivered, 0 only at the end.
  /// \throw InputError, IoError
  virtual std::size_t read(std::span<Point3> out) = 0;

  /// The number of points the header promises, where the format has one.
  virtual std::optional<std::uint64_t> announced_count() const { return std::nullopt; }

  /// What the input says about its points; empty where the format has no place for it.
  virtual const PointMetadata& metadata() const;

  /// Bytes consumed so far, for reports and progress.
  virtual std::uint64_t bytes_read() const = 0;
};

/// Opens `path`, "-" for standard input. kAuto looks at the first bytes, then at the name's ending;
/// raw formats (f32, f64) are recognized by the ending alone.
/// \throw InputError unknown format; IoError cannot open
std::unique_ptr<PointSource> open_point_source(const std::string& path, InputFormat format);

}  // namespace stream_recon
