#include "io/pvtp_index.h"

#include <filesystem>

#include "io/byte_source.h"
#include "io/xml_reader.h"

namespace stream_recon {

std::vector<std::string> read_pvtp_index(const std::string& path) {
  ByteSource source(path);
  XmlReader xml(source);
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  std::vector<std::string> pieces;
  bool is_index = false;
  for (XmlEvent event = xml.next(); event.kind != XmlEvent::Kind::kFinished; event = xml.next()) {
    if (event.kind != XmlEvent::Kind::kStart) continue;
    if (event.name == "VTKFile") is_index = event.attribute("type") == "PPolyData";
    if (!is_index) source.fail("not an index of surface pieces; give a .pvtp file");
    if (event.name != "Piece") continue;
    const std::string_view piece = event.attribute("Source");
    if (piece.empty()) source.fail("a piece without a Source; correct the index");
    pieces.push_back((folder / piece).string());
  }
  return pieces;
}

}  // namespace stream_recon
