#include "io/tetrahedra_writer.h"

#include <algorithm>
#include <cstddef>
#include <span>

#include "io/file.h"
#include "io/vtk_xml_blocks.h"
#include "io/vtk_xml_document.h"
#include "io/vtk_xml_mesh.h"

namespace stream_recon {
namespace {

constexpr const char* kType = "UnstructuredGrid";

/// One byte a cell: VTK_TETRA.
void put_cell_types(std::uint64_t cells, VtkXmlBlocks& blocks) {
  constexpr std::byte kTetra{10};
  const std::vector<std::byte> batch(std::min<std::uint64_t>(cells, 4096), kTetra);
  while (cells > 0) {
    const auto part = std::span(batch).first(std::min<std::uint64_t>(cells, batch.size()));
    blocks.put(part);
    cells -= part.size();
  }
}

void add_cells(VtkXmlDocument& document, const TetrahedraChunk& chunk) {
  const std::uint64_t cells = chunk.tetrahedra.size();
  document.add("<Cells>\n");
  document.add_array("type=\"Int32\" Name=\"connectivity\"",
                     std::as_bytes(std::span(chunk.tetrahedra)));
  add_cell_ends(document, cells, 4);
  document.add_array("type=\"UInt8\" Name=\"types\"", cells,
                     [cells](VtkXmlBlocks& blocks) { put_cell_types(cells, blocks); });
  document.add("</Cells>\n");
}

}  // namespace

TetrahedraWriter::TetrahedraWriter(const TetrahedraWriterOptions& options)
    : scalar_(options.coordinates),
      output_({.index = options.path, .index_ending = ".pvtu", .chunk_ending = ".vtu"}) {}

void TetrahedraWriter::write(std::uint64_t number, const TetrahedraChunk& chunk) {
  VtkXmlDocument document(kType);
  document.add("<Piece NumberOfPoints=\"" + std::to_string(chunk.points.size()) +
               "\" NumberOfCells=\"" + std::to_string(chunk.tetrahedra.size()) + "\">\n");
  add_points(document, {chunk.points, chunk.global_ids, scalar_});
  add_cells(document, chunk);
  document.add("</Piece>\n");
  File file = output_.create_chunk(number);
  VtkXmlBlocks blocks;
  document.write(blocks, file);
  file.close();
}

void TetrahedraWriter::prepare() {
  output_.prepare(index_text(
      {.type = kType, .cell_data = "", .scalar = scalar_, .pieces = output_.chunk_paths()}));
}

}  // namespace stream_recon
