// Where a window's part of the crust goes, face by face.
//
// Thread rule: one thread's.
#pragma once

#include <cstdint>
#include <span>

#include "engine/crust/crust_records.h"

namespace stream_recon {

class CrustSink {
 public:
  virtual ~CrustSink() = default;
  /// In the order of their positions, each before the first face that has it. \throw IoError
  virtual void take_vertex(const CrustVertex& vertex) = 0;
  /// The triangles of one face. \throw IoError
  virtual void take_face(std::span<const CrustTriangle> triangles) = 0;
  /// No more of them. \throw IoError
  virtual void finish() = 0;
};

}  // namespace stream_recon
