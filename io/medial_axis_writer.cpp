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

std::string index_data() {
  std::string text = std::string("<P") + kPointData + ">\n";
  for (const char* array : kArrays) text += std::string("<PDataArray ") + array + "/>\n";
  return text + "</PPointData>\n";
}

/// 0, 1, ...: each point is a cell.
void put_numbers(std::uint64_t count, VtkXmlBlocks& blocks) {
  constexpr std::uint64_t kBatch = 4096;
  for (std::uint64_t done = 0; done < count;) {
    const std::uint64_t end = std::min(done + kBatch, count);
    ByteSink sink(std::endian::little, (end - done) * sizeof(std::int32_t));
    for (; done < end; ++done) sink.put(static_cast<std::int32_t>(done));
    blocks.put(sink.bytes());
  }
}

void add_balls(VtkXmlDocument& document, const MedialAxisChunk& chunk) {
  document.add(std::string("<") + kPointData + ">\n");
  document.add_array(kArrays[0], std::as_bytes(std::span(chunk.radius)));
  document.add_array(kArrays[1], std::as_bytes(std::span(chunk.angle)));
  document.add_array(kArrays[2], std::as_bytes(std::span(chunk.label)));
  document.add_array(kArrays[3], std::as_bytes(std::span(chunk.point_id)));
  document.add("</PointData>\n");
  add_coordinates(document, chunk.centres, Scalar::kFloat64);
  const std::uint64_t cells = chunk.centres.size();
  document.add("<Verts>\n");
  document.add_array("type=\"Int32\" Name=\"connectivity\"", cells * sizeof(std::int32_t),
                     [cells](VtkXmlBlocks& blocks) { put_numbers(cells, blocks); });
  add_cell_ends(document, cells, 1);
  document.add("</Verts>\n");
}

}  // namespace

MedialAxisWriter::MedialAxisWriter(const std::string& path)
    : output_({.index = path, .index_ending = ".pvtp", .chunk_ending = ".vtp"}) {}

void MedialAxisWriter::write(std::uint64_t number, const MedialAxisChunk& chunk) {
  is_empty_ = false;
  const std::string count = std::to_string(chunk.centres.size());
  VtkXmlDocument document(kType);
  document.add("<Piece NumberOfPoints=\"" + count + "\" NumberOfVerts=\"" + count +
               "\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n");
  add_balls(document, chunk);
  document.add("</Piece>\n");
  File file = output_.create_chunk(number);
  VtkXmlBlocks blocks;
  document.write(blocks, file);
  file.close();
}

void MedialAxisWriter::prepare() {
  if (is_empty_) write(0, {});  // readers expect a piece, even an empty one
  output_.prepare(index_text({.type = kType,
                              .point_data = index_data(),
                              .cell_data = "",
                              .scalar = Scalar::kFloat64,
                              .pieces = output_.chunk_paths()}));
}

}  // namespace stream_recon
