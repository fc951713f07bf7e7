// How the facets of the surface go from the windows to their chunks.
//
// Guarantees: a facet belongs to the chunk of its vertex of lowest rank; the border points and
// edges of a chunk are those that facets of earlier chunks use, once a use. A solid's chunk gets
// these facets instead of their edges, so that it knows all facets at its points.
// Thread rule: export_facets() as its writer; the rest const access from many.
#pragma once

#include <optional>
#include <span>
#include <tuple>

#include "engine/chunks/chunk_layout.h"
#include "engine/order/point_store.h"
#include "engine/surface/edge_census.h"
#include "engine/surface/facet_record.h"
#include "engine/windows/export_reader.h"
#include "engine/windows/export_writer.h"

namespace stream_recon {

/// A point that a facet of the earlier chunk `user` has as a vertex.
struct BorderPoint {
  PointRank rank = 0;
  std::uint64_t user = 0;

  friend bool operator==(const BorderPoint&, const BorderPoint&) = default;
  friend bool operator<(const BorderPoint& a, const BorderPoint& b) {
    return std::tie(a.rank, a.user) < std::tie(b.rank, b.user);
  }
};

/// \throw IoError
void export_facets(std::span<const FacetRecord> facets, const ChunkLayout& layout,
                   ExportWriter& out);

struct SolidExportOptions {
  ChunkLayout layout;
  /// Fills of a closure above this are left out, as if they were not there.
  std::optional<double> open_ratio;
};

/// Of a solid. \pre Each facing is known. \throw IoError
void export_solid_facets(std::span<const FacetRecord> facets, const SolidExportOptions& options,
                         ExportWriter& out);

/// What all windows have exported. \pre The reader outlives it.
class ExportedFacets {
 public:
  /// \param points the store whose ranks the facets have
  ExportedFacets(const ExportReader& reader, const ChunkLayout& layout,
                 const char* points = kPointStore)
      : points_(points),
        layout_(layout),
        facets_(reader, ExportKind::kFacets),
        border_points_(reader, ExportKind::kBorderPoints),
        border_edges_(reader, ExportKind::kBorderEdges),
        border_facets_(reader, ExportKind::kBorderFacets) {}

  const char* point_store() const { return points_; }
  const ChunkLayout& layout() const { return layout_; }
  const ExportedRecords<FacetRecord>& facets() const { return facets_; }
  const ExportedRecords<BorderPoint>& border_points() const { return border_points_; }
  /// None of a solid.
  const ExportedRecords<BorderEdge>& border_edges() const { return border_edges_; }
  /// Of a solid only: facets of earlier chunks with a point in the chunk, once each.
  const ExportedRecords<FacetRecord>& border_facets() const { return border_facets_; }

 private:
  const char* points_;
  ChunkLayout layout_;
  ExportedRecords<FacetRecord> facets_;
  ExportedRecords<BorderPoint> border_points_;
  ExportedRecords<BorderEdge> border_edges_;
  ExportedRecords<FacetRecord> border_facets_;
};

}  // namespace stream_recon
