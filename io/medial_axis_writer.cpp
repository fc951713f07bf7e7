#include "io/medial_axis_writer.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <span>

#include "io/byte_sink.h"
#include "io/coordinates.h"
#include "io/file.h"
#include "io/vtk_xml_blocks.h"
#include "io/vtk_xml_document.h"
#include "io/vtk_xml_mesh.h"

namespace stream_recon {
namespace {

constexpr const char* kType = "PolyData";
constexpr const char* kPointData = "PointData Scalars=\"Radius\"";

/// Attributes of the point data. Balls may share their sample, so its number is no global id.
constexpr std::array<const char*, 4> kArrays{
    "type=\"Float64\" Name=\"Radius\"", "type=\"Float32\" Name=\"Angle\"",
    "type=\"UInt8\" Name=\"Label\"", "type=\"Int64\" Name=\"GlobalPointId\""};

constexpr const char* kPoleId = "type=\"Int64\" Name=\"PoleId\"";
constexpr const char* kConnectivity = "type=\"Int32\" Name=\"connectivity\"";

std::string index_data(bool has_faces) {
  std::string text = std::string("<P") + kPointData + ">\n";
  for (const char* array : kArrays) text += std::string("<PDataArray ") + array + "/>\n";
  if (has_faces) text += std::string("<PDataArray ") + kPoleId + "/>\n";
  return text + "</PPointData>\n";
}

/// 0, 1, ...: each ball is a cell.
void put_numbers(std::uint64_t count, VtkXmlBlocks& blocks) {
  constexpr std::uint64_t kBatch = 4096;
  for (std::uint64_t done = 0; done < count;) {
    const std::uint64_t end = std::min(done + kBatch, count);
    ByteSink sink(std::endian::little, (end - done) * sizeof(std::int32_t));
    for (; done < end; ++done) sink.put(static_cast<std::int32_t>(done));
    blocks.put(sink.bytes());
  }
}

void add_point_data(VtkXmlDocument& document, const MedialAxisChunk& chunk, bool has_faces) {
  document.add(std::string("<") + kPointData + ">\n");
  document.add_array(kArrays[0], std::as_bytes(std::span(chunk.radius)));
  document.add_array(kArrays[1], std::as_bytes(std::span(chunk.angle)));
  document.add_array(kArrays[2], std::as_bytes(std::span(chunk.label)));
  document.add_array(kArrays[3], std::as_bytes(std::span(chunk.point_id)));
  if (has_faces) document.add_array(kPoleId, std::as_bytes(std::span(chunk.pole_id)));
  document.add("</PointData>\n");
}

/// \param kind element of cells of `corners` points
template <std::size_t corners>
void add_faces(VtkXmlDocument& document, const std::string& kind,
               const std::vector<std::array<std::uint32_t, corners>>& faces) {
  document.add("<" + kind + ">\n");
  document.add_array(kConnectivity, std::as_bytes(std::span(faces)));
  add_cell_ends(document, faces.size(), corners);
  document.add("</" + kind + ">\n");
}

void add_balls(VtkXmlDocument& document, const MedialAxisChunk& chunk, bool has_faces) {
  add_point_data(document, chunk, has_faces);
  add_coordinates(document, chunk.centres, Scalar::kFloat64);
  const std::uint64_t cells = chunk.own_count;
  document.add("<Verts>\n");
  document.add_array(kConnectivity, cells * sizeof(std::int32_t),
                     [cells](VtkXmlBlocks& blocks) { put_numbers(cells, blocks); });
  add_cell_ends(document, cells, 1);
  document.add("</Verts>\n");
  if (!has_faces) return;
  add_faces(document, "Lines", chunk.edges);
  add_faces(document, "Polys", chunk.triangles);
}

std::string piece_tag(const MedialAxisChunk& chunk) {
  return "<Piece NumberOfPoints=\"" + std::to_string(chunk.centres.size()) + "\" NumberOfVerts=\"" +
         std::to_string(chunk.own_count) + "\" NumberOfLines=\"" +
         std::to_string(chunk.edges.size()) + "\" NumberOfStrips=\"0\" NumberOfPolys=\"" +
         std::to_string(chunk.triangles.size()) + "\">\n";
}

}  // namespace

MedialAxisWriter::MedialAxisWriter(const std::string& path, bool has_faces)
    : output_({.index = path, .index_ending = ".pvtp", .chunk_ending = ".vtp"}),
      has_faces_(has_faces) {}

void MedialAxisWriter::write(std::uint64_t number, const MedialAxisChunk& chunk) {
  is_empty_ = false;
  VtkXmlDocument document(kType);
  document.add(piece_tag(chunk));
  add_balls(document, chunk, has_faces_);
  document.add("</Piece>\n");
  File file = output_.create_chunk(number);
  VtkXmlBlocks blocks;
  document.write(blocks, file);
  file.close();
}

void MedialAxisWriter::prepare() {
  if (is_empty_) write(0, {});  // readers expect a piece, even an empty one
  output_.prepare(index_text({.type = kType,
                              .point_data = index_data(has_faces_),
                              .cell_data = "",
                              .scalar = Scalar::kFloat64,
                              .pieces = output_.chunk_paths()}));
}

}  // namespace stream_recon
