#include "io/chunked_mesh_source.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "io/error.h"
#include "io/pvtp_index.h"
#include "io/vtp_mesh_reader.h"

namespace stream_recon {
namespace {

/// The first sheet of a point keeps its id.
std::uint64_t number_of_sheet(const std::string& chunk, std::uint64_t id, std::uint32_t sheet) {
  constexpr int kIdBits = 40;
  constexpr int kSheetBits = 24;
  if (sheet != 0 && (id >> kIdBits != 0 || sheet >> kSheetBits != 0)) {
    throw InputError(chunk + ": GlobalPointId " + std::to_string(id) + " with Sheet " +
                     std::to_string(sheet) + " is too large; ids below 2^40 can have 2^24 sheets");
  }
  return std::uint64_t{sheet} << kIdBits | id;
}

class ChunkedMesh final : public MeshSource {
 public:
  explicit ChunkedMesh(std::vector<std::string> chunks) : chunks_(std::move(chunks)) {
    for (const std::string& chunk : chunks_) {
      const VtpMeshSize size = read_vtp_mesh_size(chunk);
      memory_bytes_ = std::max(memory_bytes_, size.memory_bytes());
      has_ids_ = has_ids_ || size.has_global_ids;
    }
  }

  std::uint64_t memory_bytes() const override { return memory_bytes_; }
  bool has_copies() const override { return has_ids_; }

  void read(MeshVisitor& visitor) override {
    for (const std::string& chunk : chunks_) visit(chunk, visitor);
  }

 private:
  void visit(const std::string& chunk, MeshVisitor& visitor) const {
    const VtpMesh mesh = read_vtp_mesh(chunk);
    if (mesh.global_ids.empty() && !mesh.points.empty() && chunks_.size() > 1) {
      throw InputError(chunk +
                       ": no GlobalPointId, so nobody can tell which points it shares with other "
                       "chunks; write the ids, or one file");
    }
    const auto number = [&](std::size_t point) -> std::uint64_t {
      if (mesh.global_ids.empty()) return point;
      const std::uint64_t id = mesh.global_ids[point];
      return mesh.sheets.empty() ? id : number_of_sheet(chunk, id, mesh.sheets[point]);
    };
    for (std::size_t i = 0; i < mesh.points.size(); ++i) visitor.vertex(number(i), mesh.points[i]);
    for (const auto& [a, b, c] : mesh.triangles) {
      visitor.triangle({number(a), number(b), number(c)},
                       {mesh.points[a], mesh.points[b], mesh.points[c]});
    }
  }

  std::vector<std::string> chunks_;
  std::uint64_t memory_bytes_ = 0;
  bool has_ids_ = false;
};

}  // namespace

std::unique_ptr<MeshSource> open_chunked_mesh(const std::string& path) {
  if (path.ends_with(".vtp")) return std::make_unique<ChunkedMesh>(std::vector{path});
  return std::make_unique<ChunkedMesh>(read_pvtp_index(path));
}

}  // namespace stream_recon
