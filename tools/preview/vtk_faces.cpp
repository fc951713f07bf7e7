// Polygons of a binary legacy VTK file, as versions before 5.1 write them.

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>

#include "io/error.h"
#include "io/text_reader.h"
#include "io/vtk_legacy_header.h"
#include "io/vtk_legacy_scanner.h"
#include "tools/preview/face_batch.h"
#include "tools/preview/mesh_parts.h"

namespace stream_recon {
namespace {

constexpr std::uint32_t kMostCorners = 1024;

/// Where the parts of the file are.
struct VtkLayout {
  PointLayout points;
  std::uint64_t polygons = 0;
  std::uint64_t polygons_offset = 0;
  std::optional<std::uint64_t> delta_offset;    ///< float32 a polygon
  std::optional<std::uint64_t> source_offset;   ///< a byte a polygon
  std::optional<std::uint64_t> closure_offset;  ///< float32 a polygon
};

class LayoutReader {
 public:
  explicit LayoutReader(const std::string& path)
      : source_(path), text_(source_), scanner_(source_, text_) {}

  /// Nothing if the points are not followed by polygons.
  std::optional<VtkLayout> read() {
    const VtkLegacyHeader header = read_vtk_legacy_header(source_, text_);
    if (!header.binary) return read_ascii(header);
    VtkLayout layout;
    const std::size_t size = scalar_size(header.type);
    layout.points = {.offset = source_.offset(),
                     .count = header.points,
                     .stride = 3 * size,
                     .axes = {0, size, 2 * size},
                     .decode = {}};
    layout.points.decode.fill(scalar_decoder(header.type, std::endian::big));
    source_.skip(header.points * 3 * size);
    if (!word_is("POLYGONS")) return std::nullopt;
    layout.polygons = count();
    const std::uint64_t numbers = count();
    scanner_.end_line();
    if (source_.peek(7).starts_with("OFFSETS")) {
      source_.fail("polygons as version 5.1 has them are not drawn; write version 4.2, or .vtp");
    }
    layout.polygons_offset = source_.offset();
    source_.skip(numbers * sizeof(std::int32_t));
    read_cell_data(layout);
    return layout;
  }

 private:
  std::optional<VtkLayout> read_ascii(const VtkLegacyHeader& header) {
    for (std::uint64_t i = 0; i < 3 * header.points; ++i) text_.next_word();
    if (!word_is("POLYGONS")) return std::nullopt;
    source_.fail("an ASCII file with polygons is not drawn; write it as BINARY");
  }

  /// The fields that this program's own files have; what is unknown ends the search.
  void read_cell_data(VtkLayout& layout) {
    if (!word_is("CELL_DATA") || count() != layout.polygons || !word_is("FIELD")) return;
    text_.next_word();
    for (std::uint64_t fields = count(); fields > 0; --fields) {
      const std::string name(text_.next_word());
      const bool is_single = text_.next_word() == "1" && count() == layout.polygons;
      const std::string type(text_.next_word());
      const bool is_float = type == "float";
      scanner_.end_line();
      if (!is_single || (!is_float && type != "unsigned_char")) return;
      const std::uint64_t at = source_.offset();
      if (name == "Delta" && is_float) layout.delta_offset = at;
      if (name == "Closure" && is_float) layout.closure_offset = at;
      if (name == "Source" && !is_float) layout.source_offset = at;
      source_.skip(layout.polygons * (is_float ? sizeof(float) : 1));
    }
  }

  bool word_is(std::string_view keyword) {
    const std::string_view word = text_.next_word();
    return std::equal(word.begin(), word.end(), keyword.begin(), keyword.end(),
                      [](char a, char b) { return std::toupper(a) == b; });
  }

  std::uint64_t count() {
    const std::uint64_t number = scanner_.take_count();
    if (number > UINT32_MAX) source_.fail("no possible count; correct the VTK file");
    return number;
  }

  ByteSource source_;
  TextReader text_;
  VtkLegacyScanner scanner_;
};

class VtkFaces final : public MeshParts {
 public:
  VtkFaces(std::string path, const VtkLayout& layout)
      : path_(std::move(path)), file_(File::open(path_)), layout_(layout) {}

  void for_each(const std::function<void(const VtpMesh&)>& visit) override {
    ByteSource source(path_);
    source.skip(layout_.polygons_offset);
    FaceBatch batch(path_, layout_.points);
    std::vector<std::uint64_t> polygon;
    std::uint64_t taken = 0;
    bool all_triangles = true;
    for (std::uint64_t i = 0; i < layout_.polygons; ++i) {
      read(source, polygon);
      all_triangles &= polygon.size() == 3;
      batch.add(polygon);
      if (!batch.is_full() && i + 1 < layout_.polygons) continue;
      VtpMesh mesh = batch.take();
      if (all_triangles) add_data(taken, mesh);
      taken = i + 1;
      visit(mesh);
    }
  }

 private:
  static void read(ByteSource& source, std::vector<std::uint64_t>& polygon) {
    const auto number = [&source] {
      const std::string_view bytes = source.peek(sizeof(std::uint32_t));
      if (bytes.size() < sizeof(std::uint32_t)) source.fail("the file ends inside a polygon");
      const auto value = load_scalar<std::uint32_t>(bytes.data(), std::endian::big);
      source.consume(sizeof value);
      return value;
    };
    const std::uint32_t corners = number();
    if (corners > kMostCorners) source.fail("a polygon of too many corners; the file is damaged");
    polygon.clear();
    for (std::uint32_t i = 0; i < corners; ++i) polygon.push_back(number());
  }

  void add_data(std::uint64_t first, VtpMesh& mesh) const {
    const std::size_t count = mesh.triangles.size();
    if (layout_.delta_offset) mesh.delta = floats(*layout_.delta_offset, first, count);
    if (layout_.closure_offset) mesh.closure = floats(*layout_.closure_offset, first, count);
    if (layout_.source_offset) {
      mesh.source.resize(count);
      file_.read_at(*layout_.source_offset + first, std::as_writable_bytes(std::span(mesh.source)));
    }
  }

  /// Those of `count` polygons, of an array that begins at byte `offset`.
  std::vector<float> floats(std::uint64_t offset, std::uint64_t first, std::size_t count) const {
    std::vector<std::byte> bytes(count * sizeof(float));
    file_.read_at(offset + first * sizeof(float), bytes);
    std::vector<float> values;
    values.reserve(count);
    for (std::size_t i = 0; i < bytes.size(); i += sizeof(float)) {
      values.push_back(
          load_scalar<float>(reinterpret_cast<const char*>(bytes.data()) + i, std::endian::big));
    }
    return values;
  }

  std::string path_;
  File file_;
  VtkLayout layout_;
};

}  // namespace

std::unique_ptr<MeshParts> open_vtk_faces(const std::string& path) {
  const std::optional<VtkLayout> layout = LayoutReader(path).read();
  if (!layout || layout->polygons == 0) return nullptr;
  return std::make_unique<VtkFaces>(path, *layout);
}

}  // namespace stream_recon
