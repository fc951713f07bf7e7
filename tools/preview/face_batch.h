// Faces that name points of a large file, made into a part with points of its own.
//
// Points are read through a small cache, so that faces near each other in the file cost few reads.
// Memory: 4 MB of cache, about 100 bytes a face of the batch. Thread rule: one thread.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "io/file.h"
#include "io/scalar_type.h"
#include "io/vtp_mesh_reader.h"

namespace stream_recon {

/// Where the points are: records of `stride` bytes from byte `offset` on.
struct PointLayout {
  std::uint64_t offset = 0;
  std::uint64_t count = 0;
  std::size_t stride = 0;
  std::array<std::size_t, 3> axes{};  ///< bytes of x, y, z in a record
  std::array<ScalarDecoder, 3> decode{};
};

class FaceBatch {
 public:
  static constexpr std::size_t kFull = std::size_t{1} << 16;

  /// \throw IoError
  FaceBatch(const std::string& path, const PointLayout& layout);

  /// Adds a polygon as a fan of triangles. \throw InputError a corner that is not there
  void add(const std::vector<std::uint64_t>& polygon);
  bool is_full() const { return faces_.size() >= kFull; }
  bool is_empty() const { return faces_.empty(); }
  /// The faces added since the last call, with the numbers of their points. \throw IoError
  VtpMesh take();

 private:
  struct Page {
    std::uint64_t number = UINT64_MAX;
    std::vector<std::byte> bytes;
  };

  Point3 point(std::uint64_t number);

  File file_;
  PointLayout layout_;
  std::uint64_t page_points_;
  std::vector<Page> pages_;
  std::vector<std::array<std::uint64_t, 3>> faces_;
};

}  // namespace stream_recon
