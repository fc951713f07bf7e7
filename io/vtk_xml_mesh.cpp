#include "io/vtk_xml_mesh.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <string_view>

#include "io/byte_sink.h"
#include "io/error.h"

namespace stream_recon {
namespace {

/// Values that are made before they go to the compressor together.
constexpr std::size_t kBatch = 4096;

std::string vtk_type(Scalar scalar) {
  return scalar == Scalar::kFloat32 ? "Float32" : "Float64";
}

std::string points_attributes(Scalar scalar) {
  return "type=\"" + vtk_type(scalar) + "\" Name=\"Points\" NumberOfComponents=\"3\"";
}

constexpr std::string_view kGlobalIdAttributes =
    "type=\"Int64\" IdType=\"1\" Name=\"GlobalPointId\"";

constexpr std::string_view kSheetAttributes = "type=\"UInt32\" Name=\"Sheet\"";

std::string point_data(bool has_sheets) {
  return "<PPointData GlobalIds=\"GlobalPointId\">\n<PDataArray " +
         std::string(kGlobalIdAttributes) + "/>\n" +
         (has_sheets ? "<PDataArray " + std::string(kSheetAttributes) + "/>\n" : "") +
         "</PPointData>\n";
}

std::string escape_xml(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

}  // namespace

void add_points(VtkXmlDocument& document, const VtkXmlPoints& points) {
  document.add("<PointData GlobalIds=\"GlobalPointId\">\n");
  // Ids are below 2^63, so unsigned and signed are the same bytes.
  document.add_array(kGlobalIdAttributes, std::as_bytes(points.global_ids));
  if (points.sheets) document.add_array(kSheetAttributes, std::as_bytes(*points.sheets));
  document.add("</PointData>\n");
  add_coordinates(document, points.points, points.scalar);
}

void add_coordinates(VtkXmlDocument& document, std::span<const Point3> points, Scalar scalar) {
  document.add("<Points>\n");
  const std::size_t point_bytes = 3 * scalar_bytes(scalar);
  document.add_array(points_attributes(scalar), points.size() * point_bytes,
                     [points, scalar, point_bytes](VtkXmlBlocks& blocks) {
                       for (auto rest = points; !rest.empty();) {
                         const auto batch = rest.first(std::min(rest.size(), kBatch));
                         ByteSink sink(std::endian::little, batch.size() * point_bytes);
                         for (const Point3& point : batch) put_point(sink, point, scalar);
                         blocks.put(sink.bytes());
                         rest = rest.subspan(batch.size());
                       }
                     });
  document.add("</Points>\n");
}

void add_cell_ends(VtkXmlDocument& document, std::uint64_t cells, std::uint32_t corners) {
  if (cells > std::numeric_limits<std::int32_t>::max() / corners) {
    throw IoError("cannot write a chunk of " + std::to_string(cells) + " cells of " +
                  std::to_string(corners) +
                  " points: its corners are counted in 32 bits; give a smaller --chunk-points");
  }
  document.add_array("type=\"Int32\" Name=\"offsets\"", cells * sizeof(std::int32_t),
                     [cells, corners](VtkXmlBlocks& blocks) {
                       for (std::uint64_t done = 0; done < cells;) {
                         const std::uint64_t batch = std::min<std::uint64_t>(cells - done, kBatch);
                         ByteSink sink(std::endian::little, batch * sizeof(std::int32_t));
                         for (const std::uint64_t end = done + batch; done < end;) {
                           sink.put(static_cast<std::int32_t>(++done * corners));
                         }
                         blocks.put(sink.bytes());
                       }
                     });
}

std::string index_text(const VtkXmlIndex& index) {
  const std::string type = "P" + index.type;
  std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"" + type + "\" " +
                     kVtkXmlAttributes + ">\n<" + type + " GhostLevel=\"0\">\n" +
                     (index.point_data.empty() ? point_data(index.has_sheets) : index.point_data) +
                     index.cell_data + "<PPoints>\n<PDataArray " + points_attributes(index.scalar) +
                     "/>\n</PPoints>\n";
  for (const std::string& piece : index.pieces) {
    text += "<Piece Source=\"" + escape_xml(piece) + "\"/>\n";
  }
  return text + "</" + type + ">\n</VTKFile>\n";
}

}  // namespace stream_recon
