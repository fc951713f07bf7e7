#include "tools/preview/mesh_parts.h"

#include <vector>

#include "io/error.h"
#include "io/point_source.h"
#include "io/pvtp_index.h"

namespace stream_recon {
namespace {

class Chunks final : public MeshParts {
 public:
  explicit Chunks(std::vector<std::string> paths) : paths_(std::move(paths)) {}

  void for_each(const std::function<void(const VtpMesh&)>& visit) override {
    for (const std::string& path : paths_) {
      VtpMesh mesh = read_vtp_mesh(path);
      if (mesh.global_ids.empty() && paths_.size() == 1) number(mesh);
      visit(mesh);
    }
  }

 private:
  static void number(VtpMesh& mesh) {
    mesh.global_ids.reserve(mesh.points.size());
    while (mesh.global_ids.size() < mesh.points.size()) {
      mesh.global_ids.push_back(mesh.global_ids.size());
    }
  }

  std::vector<std::string> paths_;
};

class Cloud final : public MeshParts {
 public:
  explicit Cloud(std::string path) : path_(std::move(path)) {
    open_point_source(path_, InputFormat::kAuto);
  }

  void for_each(const std::function<void(const VtpMesh&)>& visit) override {
    const auto source = open_point_source(path_, InputFormat::kAuto);
    std::vector<Point3> buffer(kPointsAtOnce);
    while (const std::size_t count = source->read(buffer)) {
      VtpMesh part;
      part.points.assign(buffer.begin(), buffer.begin() + static_cast<std::ptrdiff_t>(count));
      visit(part);
    }
  }

 private:
  static constexpr std::size_t kPointsAtOnce = std::size_t{1} << 16;

  std::string path_;
};

}  // namespace

std::unique_ptr<MeshParts> open_mesh_parts(const std::string& path) {
  if (path == "-") throw InputError("standard input: a picture reads its input twice; give a file");
  if (path.ends_with(".pvtp")) return std::make_unique<Chunks>(read_pvtp_index(path));
  if (path.ends_with(".vtp")) return std::make_unique<Chunks>(std::vector{path});
  std::unique_ptr<MeshParts> faces;
  if (path.ends_with(".ply")) faces = open_ply_faces(path);
  if (path.ends_with(".vtk")) faces = open_vtk_faces(path);
  if (faces != nullptr) return faces;
  return std::make_unique<Cloud>(path);
}

}  // namespace stream_recon
