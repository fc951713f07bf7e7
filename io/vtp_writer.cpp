#include "io/vtp_writer.h"

#include <span>
#include <string>

#include "io/vtk_xml_document.h"
#include "io/vtk_xml_mesh.h"

namespace stream_recon {
namespace {

std::string piece_tag(const SurfaceChunk& chunk) {
  return "<Piece NumberOfPoints=\"" + std::to_string(chunk.points.size()) +
         "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"" +
         std::to_string(chunk.triangles.size()) + "\">\n";
}

void add_cells(VtkXmlDocument& document, const SurfaceChunk& chunk, bool has_closure) {
  document.add("<CellData Scalars=\"Delta\">\n");
  document.add_array("type=\"Float32\" Name=\"Delta\"", std::as_bytes(std::span(chunk.delta)));
  document.add_array("type=\"UInt8\" Name=\"Source\"", std::as_bytes(std::span(chunk.source)));
  if (has_closure) {
    document.add_array("type=\"Float32\" Name=\"Closure\"",
                       std::as_bytes(std::span(chunk.closure)));
  }
  document.add("</CellData>\n<Polys>\n");
  document.add_array("type=\"Int32\" Name=\"connectivity\"",
                     std::as_bytes(std::span(chunk.triangles)));
  add_cell_ends(document, chunk.triangles.size(), 3);
  document.add("</Polys>\n");
}

}  // namespace

std::optional<std::span<const std::uint32_t>> VtpWriter::sheets_of(
    const SurfaceChunk& chunk) const {
  if (!options_.has_sheets) return std::nullopt;
  return std::span(chunk.sheets);
}

void VtpWriter::write(const SurfaceChunk& chunk, File& file) {
  VtkXmlDocument document("PolyData");
  document.add(piece_tag(chunk));
  add_points(document, {chunk.points, chunk.global_ids, options_.coordinates, sheets_of(chunk)});
  add_cells(document, chunk, options_.has_closure);
  document.add("</Piece>\n");
  document.write(blocks_, file);
}

}  // namespace stream_recon
