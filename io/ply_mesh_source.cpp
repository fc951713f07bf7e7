#include "io/ply_mesh_source.h"

#include <algorithm>
#include <string>

#include "io/ply_header.h"
#include "io/ply_values.h"
#include "io/stored_points.h"

namespace stream_recon {
namespace {

bool is_corner_list(const PlyProperty& property) {
  return property.is_list && (property.name == "vertex_indices" || property.name == "vertex_index");
}

class PlyMesh final : public MeshSource {
 public:
  explicit PlyMesh(const MeshSourceOptions& options)
      : source_(options.path),
        header_(read_ply_header(source_)),
        values_(source_, header_),
        points_(*options.scratch, "mesh_points", options.cache_bytes),
        memory_bytes_(options.cache_bytes + (std::uint64_t{1} << 20)) {
    const auto face = std::find_if(header_.elements.begin(), header_.elements.end(),
                                   [](const PlyElement& e) { return e.name == "face"; });
    if (face == header_.elements.end()) {
      source_.fail("the PLY file has no element face: points alone are no mesh");
    }
    if (face < header_.elements.begin() + static_cast<std::ptrdiff_t>(header_.vertex)) {
      source_.fail("the faces come before the vertices; write the vertices first");
    }
    const auto& properties = face->properties;
    if (std::count_if(properties.begin(), properties.end(), is_corner_list) != 1) {
      source_.fail("element face has no list vertex_indices; name the corners so");
    }
  }

  std::uint64_t memory_bytes() const override {
    return memory_bytes_ + header_.vertices().count / 1365 * sizeof(std::uint64_t);
  }
  bool has_copies() const override { return false; }

  void read(MeshVisitor& visitor) override {
    for (const PlyElement& element : header_.elements) {
      if (element.name == "vertex") {
        read_vertices(element, visitor);
      } else if (element.name == "face") {
        read_faces(element, visitor);
      } else {
        values_.skip(element);
      }
    }
    values_.check_end();
  }

 private:
  void read_vertices(const PlyElement& element, MeshVisitor& visitor) {
    for (std::uint64_t number = 0; number < element.count; ++number) {
      const Point3 point = take_vertex(element);
      points_.append(point);
      visitor.vertex(number, point);
    }
    points_.finish();
  }

  Point3 take_vertex(const PlyElement& element) {
    Point3 point;
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      if (i == header_.axes[0]) {
        point.x = values_.take_number(property.type);
      } else if (i == header_.axes[1]) {
        point.y = values_.take_number(property.type);
      } else if (i == header_.axes[2]) {
        point.z = values_.take_number(property.type);
      } else {
        values_.skip(property);
      }
    }
    return point;
  }

  void read_faces(const PlyElement& element, MeshVisitor& visitor) {
    for (std::uint64_t face = 0; face < element.count; ++face) {
      MeshTriangle corners{};
      for (const PlyProperty& property : element.properties) {
        if (is_corner_list(property)) {
          corners = take_corners(property, face);
        } else {
          values_.skip(property);
        }
      }
      const auto [a, b, c] = corners;
      visitor.triangle(corners, {Point3(points_[a]), Point3(points_[b]), Point3(points_[c])});
    }
  }

  MeshTriangle take_corners(const PlyProperty& property, std::uint64_t face) {
    const std::uint64_t length = values_.take_index(property.count_type);
    if (length != 3) {
      values_.fail("face " + std::to_string(face) + " has " + std::to_string(length) +
                   " corners; triangulate the file");
    }
    MeshTriangle corners{};
    for (std::uint64_t& corner : corners) {
      corner = values_.take_index(property.type);
      if (corner >= points_.count()) {
        values_.fail("face " + std::to_string(face) + " names vertex " + std::to_string(corner) +
                     ", which is not there; the file is damaged");
      }
    }
    return corners;
  }

  ByteSource source_;
  PlyHeader header_;
  PlyValues values_;
  StoredPoints points_;
  std::uint64_t memory_bytes_;
};

}  // namespace

std::unique_ptr<MeshSource> open_ply_mesh(const MeshSourceOptions& options) {
  return std::make_unique<PlyMesh>(options);
}

}  // namespace stream_recon
