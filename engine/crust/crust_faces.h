// The part of the crust that a window of the power diagram emits: the faces between its owned poles
// and poles outside, in triangles.
//
// A face is the polygon of the vertices dual to the cells around an edge from a pole inside to one
// outside. Guarantees: corners and triangles of a face are functions of the poles alone, so that
// faces of different windows fit along their edges without cracks; every face of the crust is
// handed on by one window. Corners with a common sample are one vertex, the sample. A face with a
// corner at infinity is left out and counted. Thread rule: one thread. Memory: about what
// crust_faces_memory() says. Source: Amenta, Choi, Kolluri, The power crust, 2001, section 3;
// docs/algorithms/crust.md
#pragma once

#include <cstdint>
#include <span>

#include "engine/crust/crust_sink.h"
#include "engine/power/power_window.h"

namespace stream_recon {

/// Rarely more.
inline constexpr std::size_t kCrustVerticesAPole = 12;

struct CrustFacesOptions {
  std::uint32_t window = 0;  ///< its number, for the vertices
  /// Ranks of the points that are no samples, ascending: no corner is put there.
  std::span<const std::uint32_t> far_ranks;
};

struct CrustFacesCounts {
  std::uint32_t vertices = 0;
  std::uint64_t faces = 0;
  std::uint64_t unbounded = 0;  ///< of these: left out
};

/// \pre build() of the window returned kDone
/// \throw IoError
CrustFacesCounts write_crust_faces(const PowerWindow& power, const CrustFacesOptions& options,
                                   CrustSink& sink);

/// What write_crust_faces() may be expected to need beside window and sink, bytes.
std::uint64_t crust_faces_memory(const PowerWindow& power);

}  // namespace stream_recon
