#include "io/vtp_writer.h"

#include <bit>
#include <cassert>
#include <cstdint>
#include <limits>
#include <span>

#include "io/byte_sink.h"
#include "io/surface_points.h"

namespace stream_recon {
namespace {

ByteSink encode_points(const SurfaceChunk& chunk, Scalar scalar) {
  ByteSink sink(std::endian::little, chunk.points.size() * 3 * scalar_bytes(scalar));
  for (const Point3& point : chunk.points) put_point(sink, point, scalar);
  return sink;
}

/// Where each triangle ends in the list of corners.
ByteSink encode_ends(std::size_t triangles) {
  assert(triangles <= std::numeric_limits<std::int32_t>::max() / 3);
  ByteSink sink(std::endian::little, triangles * sizeof(std::int32_t));
  for (std::size_t i = 1; i <= triangles; ++i) sink.put(static_cast<std::int32_t>(3 * i));
  return sink;
}

std::string piece_tag(const SurfaceChunk& chunk) {
  return "<Piece NumberOfPoints=\"" + std::to_string(chunk.points.size()) +
         "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"" +
         std::to_string(chunk.triangles.size()) + "\">\n";
}

}  // namespace

const char* const kVtkXmlAttributes =
    "version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\" "
    "compressor=\"vtkZLibDataCompressor\"";

const char* vtk_type(Scalar scalar) {
  return scalar == Scalar::kFloat32 ? "Float32" : "Float64";
}

std::string VtpWriter::data_array(const std::string& attributes, std::span<const std::byte> raw) {
  const std::string offset = std::to_string(appended_.size());
  blocks_.append(raw, appended_);
  return "<DataArray " + attributes + " format=\"appended\" offset=\"" + offset + "\"/>\n";
}

// Arrays are encoded one statement after the other, so that their order in the file is ours.

std::string VtpWriter::point_arrays(const SurfaceChunk& chunk) {
  std::string text = "<PointData GlobalIds=\"GlobalPointId\">\n";
  // Ids are below 2^63, so unsigned and signed are the same bytes.
  text += data_array("type=\"Int64\" IdType=\"1\" Name=\"GlobalPointId\"",
                     std::as_bytes(std::span(chunk.global_ids)));
  text += "</PointData>\n<Points>\n";
  text += data_array(
      "type=\"" + std::string(vtk_type(scalar_)) + "\" Name=\"Points\" NumberOfComponents=\"3\"",
      encode_points(chunk, scalar_).bytes());
  return text + "</Points>\n";
}

std::string VtpWriter::cell_arrays(const SurfaceChunk& chunk) {
  std::string text = "<CellData Scalars=\"Delta\">\n";
  text += data_array("type=\"Float32\" Name=\"Delta\"", std::as_bytes(std::span(chunk.delta)));
  text += data_array("type=\"UInt8\" Name=\"Source\"", std::as_bytes(std::span(chunk.source)));
  text += "</CellData>\n<Polys>\n";
  text +=
      data_array("type=\"Int32\" Name=\"connectivity\"", std::as_bytes(std::span(chunk.triangles)));
  text +=
      data_array("type=\"Int32\" Name=\"offsets\"", encode_ends(chunk.triangles.size()).bytes());
  return text + "</Polys>\n";
}

void VtpWriter::write(const SurfaceChunk& chunk, File& file) {
  appended_.clear();
  std::string head = "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" " +
                     std::string(kVtkXmlAttributes) + ">\n<PolyData>\n" + piece_tag(chunk);
  head += point_arrays(chunk);
  head += cell_arrays(chunk);
  head += "</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_";
  const std::string tail = "\n</AppendedData>\n</VTKFile>\n";
  file.write(std::as_bytes(std::span(head)));
  file.write(appended_);
  file.write(std::as_bytes(std::span(tail)));
}

}  // namespace stream_recon
