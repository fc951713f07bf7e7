// Faces of a binary PLY file.

#include <optional>

#include "io/error.h"
#include "io/ply_header.h"
#include "tools/preview/face_batch.h"
#include "tools/preview/mesh_parts.h"

namespace stream_recon {
namespace {

constexpr std::uint64_t kMostCorners = 1024;

bool names_corners(const PlyProperty& property) {
  return property.is_list && (property.name == "vertex_indices" || property.name == "vertex_index");
}

std::uint64_t load_integer(const char* bytes, ScalarType type, std::endian order) {
  if (type == ScalarType::kInt64) {
    return static_cast<std::uint64_t>(load_scalar<std::int64_t>(bytes, order));
  }
  if (type == ScalarType::kUint64) return load_scalar<std::uint64_t>(bytes, order);
  // A negative number becomes one that no file has points for.
  return static_cast<std::uint64_t>(static_cast<std::int64_t>(scalar_decoder(type, order)(bytes)));
}

class PlyFaces final : public MeshParts {
 public:
  PlyFaces(std::string path, PlyHeader header, std::uint64_t body)
      : path_(std::move(path)),
        header_(std::move(header)),
        order_(header_.format == PlyFormat::kBinaryBigEndian ? std::endian::big
                                                             : std::endian::little),
        points_{.offset = body} {
    find_faces();
    const PlyElement& vertices = header_.vertices();
    points_.count = vertices.count;
    points_.stride = vertices.fixed_size();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (std::size_t i = 0; i < header_.axes[axis]; ++i) {
        points_.axes[axis] += scalar_size(vertices.properties[i].type);
      }
      points_.decode[axis] = scalar_decoder(vertices.properties[header_.axes[axis]].type, order_);
    }
  }

  void for_each(const std::function<void(const VtpMesh&)>& visit) override {
    ByteSource source(path_);
    source.skip(faces_offset_);
    FaceBatch batch(path_, points_);
    std::vector<std::uint64_t> polygon;
    const PlyElement& faces = header_.elements[faces_];
    for (std::uint64_t face = 0; face < faces.count; ++face) {
      polygon.clear();
      for (const PlyProperty& property : faces.properties) read(source, property, polygon);
      batch.add(polygon);
      if (batch.is_full()) visit(batch.take());
    }
    if (!batch.is_empty()) visit(batch.take());
  }

 private:
  void find_faces() {
    std::uint64_t at = points_.offset;
    for (std::size_t i = 0; i < header_.elements.size(); ++i) {
      const PlyElement& element = header_.elements[i];
      if (i == header_.vertex) points_.offset = at;
      if (element.name == "face") {
        faces_ = i;
        faces_offset_ = at;
        if (i > header_.vertex) return;
      }
      if (element.has_list()) break;
      at += element.count * element.fixed_size();
    }
    throw InputError(path_ +
                     ": a PLY file with lists before its faces is not drawn; write the vertices, "
                     "without lists, then the faces");
  }

  void read(ByteSource& source, const PlyProperty& property,
            std::vector<std::uint64_t>& polygon) const {
    const std::size_t item = scalar_size(property.type);
    if (!property.is_list) return step(source, item);
    const std::uint64_t items = load_integer(take(source, scalar_size(property.count_type)).data(),
                                             property.count_type, order_);
    if (items > kMostCorners) source.fail("a face of more than 1024 corners; the file is damaged");
    const std::string_view bytes = take(source, items * item);
    if (!names_corners(property)) return;
    for (std::uint64_t i = 0; i < items; ++i) {
      polygon.push_back(load_integer(bytes.data() + i * item, property.type, order_));
    }
  }

  static std::string_view take(ByteSource& source, std::size_t size) {
    const std::string_view bytes = source.peek(size);
    if (bytes.size() < size) source.fail("the file ends inside a face; fetch it again");
    source.consume(size);
    return bytes;
  }
  static void step(ByteSource& source, std::size_t size) { take(source, size); }

  std::string path_;
  PlyHeader header_;
  std::endian order_;
  PointLayout points_;
  std::size_t faces_ = 0;
  std::uint64_t faces_offset_ = 0;
};

}  // namespace

std::unique_ptr<MeshParts> open_ply_faces(const std::string& path) {
  ByteSource source(path);
  const PlyHeader header = read_ply_header(source);
  bool has_faces = false;
  for (const PlyElement& element : header.elements) {
    if (element.name != "face" || element.count == 0) continue;
    for (const PlyProperty& property : element.properties) has_faces |= names_corners(property);
  }
  if (!has_faces) return nullptr;
  if (header.format == PlyFormat::kAscii) {
    throw InputError(path + ": an ascii PLY file with faces is not drawn; write it as binary");
  }
  return std::make_unique<PlyFaces>(path, header, source.offset());
}

}  // namespace stream_recon
