// Points written as a stream to a file or to standard output.
//
// Guarantees: bytes are a function of the points and the options alone; a file stands under its
// final name only after finish(), and is removed if that is never reached. kFloat32 rounds
// coordinates to nearest, kFloat64 keeps every bit, text has the fewest digits that read back as
// the same number. Memory: one buffer of 64 KiB and one frame. Thread rule: one writer.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/point_metadata.h"
#include "io/pts_encoder.h"
#include "spatial/point.h"

namespace stream_recon {

enum class PointFormat {
  kPly,  ///< binary little endian PLY, x y z of PointSinkOptions::scalar
  kXyz,  ///< text, one point a line
  kF32,  ///< raw little endian floats, x y z
  kF64,  ///< raw little endian doubles, x y z
  kPts,  ///< the framed stream of docs/formats.md, coordinates of PointSinkOptions::scalar
};

struct PointSinkOptions {
  std::string path;  ///< "-" is standard output
  PointFormat format = PointFormat::kPly;
  Scalar scalar = Scalar::kFloat64;  ///< of PLY and pts coordinates
  /// Points that will come, for PLY's header. Without it the count of a file is filled in at the
  /// end; standard output, which cannot be gone back on, demands it.
  std::optional<std::uint64_t> count = std::nullopt;
  PointMetadata metadata = {};  ///< written by kPts
};

/// The format a name's ending asks for (.xyz, .txt, .f32, .f64, .pts), else PLY.
PointFormat point_format_of(const std::string& path);

class PointSink {
 public:
  /// \pre a PLY on standard output has a count
  /// \throw IoError cannot create
  explicit PointSink(const PointSinkOptions& options);
  ~PointSink();
  PointSink(PointSink&&) noexcept;
  PointSink& operator=(PointSink&&) noexcept;

  /// \throw IoError
  void write(std::span<const Point3> points);

  /// \throw IoError; std::logic_error where a PLY header promised another count
  void finish();

  std::uint64_t points_written() const { return written_; }

 private:
  class Output;
  void put(const Point3& p);
  template <typename Real>
  void put_binary(const Point3& p);
  void put_frame();
  void finish_ply();

  PointSinkOptions options_;
  std::unique_ptr<Output> output_;
  PtsEncoder frames_;
  std::string buffer_;
  std::vector<Point3> frame_;  ///< points of the next frame, kPts only
  std::uint64_t written_ = 0;
};

}  // namespace stream_recon
