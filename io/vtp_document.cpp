#include "io/vtp_document.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "io/number_text.h"

namespace stream_recon {
namespace {

std::optional<ScalarType> type_named(std::string_view name) {
  static constexpr std::pair<std::string_view, ScalarType> kNames[] = {
      {"Int8", ScalarType::kInt8},       {"UInt8", ScalarType::kUint8},
      {"Int16", ScalarType::kInt16},     {"UInt16", ScalarType::kUint16},
      {"Int32", ScalarType::kInt32},     {"UInt32", ScalarType::kUint32},
      {"Int64", ScalarType::kInt64},     {"UInt64", ScalarType::kUint64},
      {"Float32", ScalarType::kFloat32}, {"Float64", ScalarType::kFloat64}};
  const auto* found = std::find_if(std::begin(kNames), std::end(kNames),
                                   [&](const auto& entry) { return entry.first == name; });
  if (found == std::end(kNames)) return std::nullopt;
  return found->second;
}

std::optional<VtpSection> section_named(std::string_view name) {
  if (name == "Points") return VtpSection::kPoints;
  if (name == "PointData") return VtpSection::kPointData;
  if (name == "CellData") return VtpSection::kCellData;
  if (name == "Polys") return VtpSection::kPolys;
  return std::nullopt;
}

}  // namespace

VtpDocument::VtpDocument(ByteSource& source) : source_(source), xml_(source) {
  XmlEvent event = xml_.next();
  while (event.kind == XmlEvent::Kind::kText) event = xml_.next();
  if (event.kind != XmlEvent::Kind::kStart || event.name != "VTKFile") {
    source_.fail("not a VTK XML file: its root is not <VTKFile>; check --input-format");
  }
  read_encoding(event);
}

void VtpDocument::read_encoding(const XmlEvent& root) {
  const std::string_view type = root.attribute("type");
  if (type.starts_with("P") && type != "PolyData") {
    source_.fail("a file of type " + quote_text(type) + " is an index; give the files it names");
  }
  if (type != "PolyData" && type != "UnstructuredGrid") {
    source_.fail("a VTK file of type " + quote_text(type) +
                 " is not read; give PolyData or UnstructuredGrid");
  }
  is_poly_data_ = type == "PolyData";
  const std::string_view order = root.attribute("byte_order");
  if (order != "LittleEndian" && order != "BigEndian") {
    source_.fail("byte_order " + quote_text(order) +
                 " is neither LittleEndian nor BigEndian; "
                 "correct the VTKFile tag");
  }
  encoding_.order = order == "BigEndian" ? std::endian::big : std::endian::little;
  const std::string_view header = root.attribute("header_type");
  if (header != "" && header != "UInt32" && header != "UInt64") {
    source_.fail("header_type " + quote_text(header) +
                 " is neither UInt32 nor UInt64; "
                 "correct the VTKFile tag");
  }
  encoding_.header = header == "UInt64" ? ScalarType::kUint64 : ScalarType::kUint32;
  const std::string_view compressor = root.attribute("compressor");
  if (compressor == "vtkZLibDataCompressor") {
    encoding_.compressor = VtpCompressor::kZlib;
  } else if (compressor == "vtkLZ4DataCompressor") {
    encoding_.compressor = VtpCompressor::kLz4;
  } else if (!compressor.empty()) {
    source_.fail("the compressor " + quote_text(compressor) +
                 " is not read; write the file with zlib, LZ4 or none");
  }
}

std::optional<VtpArray> VtpDocument::next() {
  for (std::string_view rest = peek(); !rest.empty(); rest = peek()) consume(rest.size());
  while (!finished_) {
    const XmlEvent event = xml_.next();
    switch (event.kind) {
      case XmlEvent::Kind::kText:
        break;
      case XmlEvent::Kind::kFinished:
        finished_ = true;
        break;
      case XmlEvent::Kind::kEnd:
        if (event.name == "Piece") in_piece_ = false;
        if (section_named(event.name)) section_ = VtpSection::kOther;
        break;
      case XmlEvent::Kind::kStart:
        if (event.name == "AppendedData") {
          appended_ =
              event.attribute("encoding") == "raw" ? VtpStorage::kAppended : VtpStorage::kBase64;
          finished_ = true;
        } else if (event.name == "Piece") {
          start_piece(event);
        } else if (event.name == "DataArray" && in_piece_) {
          array_depth_ = 1;
          return describe(event);
        } else if (in_piece_) {
          section_ = section_named(event.name).value_or(section_);
        }
    }
  }
  return std::nullopt;
}

std::string_view VtpDocument::peek() {
  while (array_depth_ > 0 && text_begin_ == text_.name.size()) {
    text_ = xml_.next();
    text_begin_ = 0;
    const bool is_text = text_.kind == XmlEvent::Kind::kText && array_depth_ == 1;
    if (text_.kind == XmlEvent::Kind::kStart) ++array_depth_;
    if (text_.kind == XmlEvent::Kind::kEnd) --array_depth_;
    if (!is_text) text_.name.clear();
  }
  return std::string_view(text_.name).substr(text_begin_);
}

void VtpDocument::start_piece(const XmlEvent& event) {
  piece_ = {};
  piece_.index = pieces_++;
  piece_.points = count_of(event, "NumberOfPoints");
  piece_.cells_before_polys = count_of(event, "NumberOfVerts") + count_of(event, "NumberOfLines");
  piece_.polys = count_of(event, "NumberOfPolys");
  piece_.cells = piece_.cells_before_polys + piece_.polys + count_of(event, "NumberOfStrips") +
                 count_of(event, "NumberOfCells");
  in_piece_ = true;
  section_ = VtpSection::kOther;
}

VtpArray VtpDocument::describe(const XmlEvent& event) const {
  VtpArray array;
  array.piece = piece_;
  array.section = section_;
  array.name = event.attribute("Name");
  const std::optional<ScalarType> type = type_named(event.attribute("type"));
  if (!type) {
    source_.fail("a data array of unknown type " + quote_text(event.attribute("type")) +
                 "; leave it out or correct its tag");
  }
  array.type = *type;
  if (!event.attribute("NumberOfComponents").empty()) {
    array.components = count_of(event, "NumberOfComponents");
  }
  array.values = values_of(array);
  const std::string_view format = event.attribute("format");
  if (format == "appended") {
    array.storage = VtpStorage::kAppended;
    array.offset = count_of(event, "offset");
  } else if (format == "binary") {
    array.storage = VtpStorage::kBase64;
  } else if (!format.empty() && format != "ascii") {
    source_.fail("a data array of unknown format " + quote_text(format) + "; correct its tag");
  }
  return array;
}

std::optional<std::uint64_t> VtpDocument::values_of(const VtpArray& array) const {
  std::uint64_t tuples = 0;
  switch (array.section) {
    case VtpSection::kPoints:
    case VtpSection::kPointData:
      tuples = piece_.points;
      break;
    case VtpSection::kCellData:
      tuples = piece_.cells;
      break;
    case VtpSection::kPolys:
      if (array.name != "offsets") return std::nullopt;
      tuples = piece_.polys;
      break;
    case VtpSection::kOther:
      return std::nullopt;
  }
  // A count of bytes must fit 64 bits as well.
  std::uint64_t bytes = 0;
  if (__builtin_mul_overflow(tuples, array.components, &bytes) || bytes > UINT64_MAX / 8) {
    source_.fail("an array of an impossible size; the file is damaged");
  }
  return tuples * array.components;
}

/// A missing count is zero.
std::uint64_t VtpDocument::count_of(const XmlEvent& event, const char* attribute) const {
  constexpr std::uint64_t kMost = UINT64_MAX / 8;
  std::string_view text = event.attribute(attribute);
  if (text.empty()) return 0;
  const std::optional<std::uint64_t> count = whole_count(text);
  if (!count || *count > kMost) {
    source_.fail(std::string(attribute) + "=" + quote_text(text) +
                 " is no possible count; "
                 "correct the tag " +
                 event.name);
  }
  return *count;
}

}  // namespace stream_recon
