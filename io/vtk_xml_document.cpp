#include "io/vtk_xml_document.h"

#include <utility>

namespace stream_recon {
namespace {

/// An array's place is known when those before it are written, the head stands before them: room is
/// left for the longest number and what closes the element.
std::string offset_field(std::uint64_t offset) {
  constexpr std::size_t kRoom = 23;
  std::string field = std::to_string(offset) + "\"/>";
  field.resize(kRoom, ' ');
  return field;
}

}  // namespace

const char* const kVtkXmlAttributes =
    "version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\" "
    "compressor=\"vtkZLibDataCompressor\"";

VtkXmlDocument::VtkXmlDocument(std::string type)
    : type_(std::move(type)),
      head_("<?xml version=\"1.0\"?>\n<VTKFile type=\"" + type_ + "\" " + kVtkXmlAttributes +
            ">\n<" + type_ + ">\n") {}

void VtkXmlDocument::add_array(std::string_view attributes, std::uint64_t raw_bytes, Fill fill) {
  head_ += "<DataArray " + std::string(attributes) + " format=\"appended\" offset=\"";
  arrays_.push_back({head_.size(), raw_bytes, std::move(fill)});
  head_ += offset_field(0) + "\n";
}

void VtkXmlDocument::add_array(std::string_view attributes, std::span<const std::byte> raw) {
  add_array(attributes, raw.size(), [raw](VtkXmlBlocks& blocks) { blocks.put(raw); });
}

void VtkXmlDocument::write(VtkXmlBlocks& blocks, File& file) {
  head_ += "</" + type_ + ">\n<AppendedData encoding=\"raw\">\n_";
  file.write(std::as_bytes(std::span(head_)));
  const std::uint64_t begin = file.position();
  for (const Array& array : arrays_) {
    const std::string field = offset_field(file.position() - begin);
    head_.replace(array.offset_at, field.size(), field);
    blocks.begin(array.raw_bytes, file);
    array.fill(blocks);
    blocks.end();
  }
  const std::string tail = "\n</AppendedData>\n</VTKFile>\n";
  file.write(std::as_bytes(std::span(tail)));
  file.write_at(0, std::as_bytes(std::span(head_)));
}

}  // namespace stream_recon
