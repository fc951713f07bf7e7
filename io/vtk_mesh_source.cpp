#include "io/vtk_mesh_source.h"

#include <optional>
#include <string>

#include "io/byte_source.h"
#include "io/number_text.h"
#include "io/stored_points.h"
#include "io/text_reader.h"
#include "io/vtk_legacy_header.h"
#include "io/vtk_legacy_scanner.h"

namespace stream_recon {
namespace {

class VtkMesh final : public MeshSource {
 public:
  explicit VtkMesh(const MeshSourceOptions& options)
      : source_(options.path),
        text_(source_),
        scanner_(source_, text_),
        header_(read_vtk_legacy_header(source_, text_)),
        points_(*options.scratch, "mesh_points", options.cache_bytes),
        memory_bytes_(options.cache_bytes + (std::uint64_t{1} << 20)) {
    scanner_.set_binary(header_.binary);
  }

  std::uint64_t memory_bytes() const override {
    return memory_bytes_ + header_.points / 1365 * sizeof(std::uint64_t);
  }
  bool has_copies() const override { return false; }

  void read(MeshVisitor& visitor) override {
    for (std::uint64_t number = 0; number < header_.points; ++number) {
      const double x = take_coordinate();
      const double y = take_coordinate();
      const double z = take_coordinate();
      points_.append({x, y, z});
      visitor.vertex(number, {x, y, z});
    }
    points_.finish();
    read_sections(visitor);
  }

 private:
  void read_sections(MeshVisitor& visitor) {
    for (;;) {
      const std::string keyword = VtkLegacyScanner::lower(text_.next_word());
      if (keyword == "metadata") {
        scanner_.skip_metadata();
      } else if (keyword == "vertices" || keyword == "lines") {
        skip_cells();
      } else if (keyword == "polygons") {
        return read_polygons(visitor);
      } else if (keyword.empty() || keyword == "cell_data" || keyword == "point_data") {
        return;
      } else {
        text_.fail(quote_text(keyword) + " where POLYGONS should be; give a POLYDATA of triangles");
      }
    }
  }

  void skip_cells() {
    scanner_.take_count();
    const std::uint64_t numbers = scanner_.take_count();
    scanner_.end_line();
    for (std::uint64_t i = 0; i < numbers; ++i) take_integer();
  }

  void read_polygons(MeshVisitor& visitor) {
    const std::uint64_t polygons = scanner_.take_count();
    const std::uint64_t numbers = scanner_.take_count();
    scanner_.end_line();
    if (source_.peek(7).starts_with("OFFSETS")) {
      text_.fail("polygons in the layout of version 5; write version 4.2, .vtp or .ply");
    }
    if (numbers != scanner_.product(4, polygons)) {
      text_.fail("not all polygons are triangles; triangulate the file");
    }
    for (std::uint64_t polygon = 0; polygon < polygons; ++polygon) {
      if (take_integer() != 3) {
        fail_at(polygon, "is no triangle; triangulate the file");
      }
      MeshTriangle corners{};
      for (std::uint64_t& corner : corners) {
        corner = take_integer();
        if (corner >= points_.count()) {
          fail_at(polygon, "names point " + std::to_string(corner) +
                               ", which is not there; the file is damaged");
        }
      }
      const auto [a, b, c] = corners;
      visitor.triangle(corners, {Point3(points_[a]), Point3(points_[b]), Point3(points_[c])});
    }
  }

  double take_coordinate() {
    const std::size_t size = scalar_size(header_.type);
    if (header_.binary) {
      const double value = scalar_decoder(header_.type, std::endian::big)(peek(size));
      source_.consume(size);
      return value;
    }
    const std::string_view word = take_word();
    const std::optional<double> value =
        header_.type == ScalarType::kFloat32 ? whole_float(word) : whole_double(word);
    if (!value) text_.fail(quote_text(word) + " is no number; correct the line");
    return *value;
  }

  std::uint64_t take_integer() {
    if (header_.binary) {
      const auto value = load_scalar<std::uint32_t>(peek(sizeof(std::uint32_t)), std::endian::big);
      source_.consume(sizeof(std::uint32_t));
      return value;
    }
    const std::string_view word = take_word();
    const std::optional<std::uint64_t> value = whole_count(word);
    if (!value) text_.fail(quote_text(word) + " is no count or index; correct the line");
    return *value;
  }

  std::string_view take_word() {
    const std::string_view word = text_.next_word();
    if (word.empty()) fail_short();
    if (!text_.terminated()) {
      text_.fail("no line end behind the last value, so digits may be missing; add the line end");
    }
    return word;
  }

  const char* peek(std::size_t size) {
    const std::string_view ready = source_.peek(size);
    if (ready.size() < size) fail_short();
    return ready.data();
  }

  [[noreturn]] void fail_short() const {
    source_.fail("the file ends inside its mesh; it is cut short, fetch it again");
  }

  [[noreturn]] void fail_at(std::uint64_t polygon, const std::string& what) const {
    source_.fail("polygon " + std::to_string(polygon) + " " + what);
  }

  ByteSource source_;
  TextReader text_;
  VtkLegacyScanner scanner_;
  VtkLegacyHeader header_;
  StoredPoints points_;
  std::uint64_t memory_bytes_;
};

}  // namespace

std::unique_ptr<MeshSource> open_vtk_mesh(const MeshSourceOptions& options) {
  return std::make_unique<VtkMesh>(options);
}

}  // namespace stream_recon
