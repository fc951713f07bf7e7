// Patches on their way to the surface, as facets beside the gamma shape's.
//
// Guarantees: a triangle that the solid has as well keeps its angle and closure; others, which are
// no Delaunay facets, have kNoAngle and no closure. Thread rule: one thread. Memory: memory().
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/hybrid/stored_hole.h"
#include "engine/stage_context.h"
#include "engine/surface/facet_export.h"

namespace stream_recon {

/// Degrees: that of the sharpest facets, which the gamma shape lacks first.
inline constexpr float kNoAngle = 180;

class PatchWriter {
 public:
  /// \pre No other export of kLabelledPrefix has `name_rank` as first rank.
  PatchWriter(const SolidExportOptions& options, std::uint64_t name_rank,
              const StageContext& context)
      : options_(options), out_(context.scratch, name_rank, kLabelledPrefix) {}

  static constexpr std::uint64_t memory() { return ExportWriter::memory(); }

  /// \throw IoError
  void write(const StoredHole& hole, std::span<const HoleTriangle> patch);
  /// Its fills, as they are. \throw IoError
  void write_fills(const StoredHole& hole);
  /// No more. \throw IoError
  void finish() { out_.finish(); }

 private:
  const SolidExportOptions& options_;
  ExportWriter out_;
  std::vector<FacetRecord> facets_;
};

}  // namespace stream_recon
