#include "io/points_writer.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "io/atomic_output.h"
#include "io/byte_sink.h"
#include "io/folder.h"

namespace stream_recon {
namespace {

constexpr const char* kSpool = "unused_points";
constexpr std::uint64_t kPiece = std::uint64_t{1} << 20;

}  // namespace

PointsWriter::PointsWriter(PointsWriterOptions options)
    : options_(std::move(options)),
      file_(create_beside(options_.path)),
      staged_(file_.path(), TemporaryPath::Kind::kFile),
      spool_(options_.scratch->create(kSpool)) {}

PointsWriter::~PointsWriter() {
  if (spool_.is_open()) options_.scratch->remove(kSpool);
}

void PointsWriter::write(std::uint64_t chunk, std::span<const Point3> points) {
  if (points.empty()) return;
  ByteSink bytes(std::endian::little, points.size() * 3 * scalar_bytes(options_.coordinates));
  for (const Point3& point : points) put_point(bytes, point, options_.coordinates);
  const std::lock_guard lock(mutex_);
  parts_.push_back({chunk, spool_.position(), points.size()});
  spool_.write(bytes.bytes());
}

std::string PointsWriter::header() const {
  std::uint64_t count = 0;
  for (const Part& part : parts_) count += part.count;
  const std::string type = options_.coordinates == Scalar::kFloat32 ? "float" : "double";
  std::string text = "ply\nformat binary_little_endian 1.0\ncomment stream-recon\n";
  text += "element vertex " + std::to_string(count) + "\n";
  for (const char* axis : {"x", "y", "z"}) text += "property " + type + " " + axis + "\n";
  return text + "end_header\n";
}

void PointsWriter::move_parts_to(File& target) {
  std::sort(parts_.begin(), parts_.end(),
            [](const Part& a, const Part& b) { return a.chunk < b.chunk; });
  const std::uint64_t point_bytes = 3 * scalar_bytes(options_.coordinates);
  std::vector<std::byte> piece;
  for (const Part& part : parts_) {
    const std::uint64_t end = part.offset + part.count * point_bytes;
    for (std::uint64_t at = part.offset; at < end; at += piece.size()) {
      piece.resize(std::min(kPiece, end - at));
      spool_.read_at(at, piece);
      target.write(piece);
    }
  }
  spool_ = File();
  options_.scratch->remove(kSpool);
}

void PointsWriter::prepare() {
  const std::string text = header();
  file_.write(std::as_bytes(std::span(text)));
  move_parts_to(file_);
  file_.sync();
  file_.close();
}

void PointsWriter::publish() {
  old_ = temporary_name_beside(options_.path);
  if (path_exists(options_.path)) renames_.rename(options_.path, old_);
  renames_.rename(staged_.path(), options_.path);
  sync_parent_folder(options_.path);
}

void PointsWriter::keep() noexcept {
  renames_.commit();
  staged_.keep();
  remove_file(old_.c_str());
}

}  // namespace stream_recon
