#include "tools/preview/face_batch.h"

#include <algorithm>

#include "io/error.h"

namespace stream_recon {
namespace {

constexpr std::size_t kPages = 256;
constexpr std::size_t kPageBytes = std::size_t{16} << 10;

}  // namespace

FaceBatch::FaceBatch(const std::string& path, const PointLayout& layout)
    : file_(File::open(path)),
      layout_(layout),
      page_points_(std::max<std::size_t>(1, kPageBytes / layout.stride)),
      pages_(kPages) {}

void FaceBatch::add(const std::vector<std::uint64_t>& polygon) {
  for (const std::uint64_t corner : polygon) {
    if (corner >= layout_.count) {
      throw InputError(file_.path() + ": a face names point " + std::to_string(corner) + " of " +
                       std::to_string(layout_.count) + "; the file is damaged, fetch it again");
    }
  }
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    faces_.push_back({polygon[0], polygon[i - 1], polygon[i]});
  }
}

VtpMesh FaceBatch::take() {
  VtpMesh mesh;
  std::vector<std::uint64_t>& ids = mesh.global_ids;
  ids.reserve(3 * faces_.size());
  for (const auto& face : faces_) ids.insert(ids.end(), face.begin(), face.end());
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  mesh.points.reserve(ids.size());
  for (const std::uint64_t id : ids) mesh.points.push_back(point(id));
  const auto place = [&ids](std::uint64_t id) {
    return static_cast<std::uint32_t>(std::lower_bound(ids.begin(), ids.end(), id) - ids.begin());
  };
  mesh.triangles.reserve(faces_.size());
  for (const auto& [a, b, c] : faces_) mesh.triangles.push_back({place(a), place(b), place(c)});
  faces_.clear();
  return mesh;
}

Point3 FaceBatch::point(std::uint64_t number) {
  const std::uint64_t page_number = number / page_points_;
  Page& page = pages_[page_number % kPages];
  if (page.number != page_number) {
    const std::uint64_t first = page_number * page_points_;
    page.bytes.resize(std::min(page_points_, layout_.count - first) * layout_.stride);
    page.number = UINT64_MAX;
    file_.read_at(layout_.offset + first * layout_.stride, page.bytes);
    page.number = page_number;
  }
  const auto* record =
      reinterpret_cast<const char*>(page.bytes.data()) + (number % page_points_) * layout_.stride;
  return {layout_.decode[0](record + layout_.axes[0]), layout_.decode[1](record + layout_.axes[1]),
          layout_.decode[2](record + layout_.axes[2])};
}

}  // namespace stream_recon
