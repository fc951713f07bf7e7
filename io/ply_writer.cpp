#include "io/ply_writer.h"

#include <bit>
#include <cstdint>
#include <string>

#include "io/byte_sink.h"
#include "io/coordinates.h"
#include "io/output_target.h"
#include "io/spooled_parts.h"
#include "io/surface_points.h"

namespace stream_recon {
namespace {

enum Part : std::size_t { kVertices, kFaces, kPartCount };

constexpr std::size_t kFaceBytes = 1 + 3 * sizeof(std::int32_t);

class PlyWriter final : public SurfaceWriter {
 public:
  explicit PlyWriter(const SurfaceWriterOptions& options)
      : scalar_(options.coordinates), parts_(*options.scratch, kPartCount), target_(options.path) {}

  bool takes_chunks_in_order() const override { return true; }
  void write(std::uint64_t number, const SurfaceChunk& chunk) override;
  std::uint64_t bytes_written() const override { return bytes_written_; }

 private:
  void complete() override;
  void publish() override { target_.commit(); }
  std::string header() const;

  Scalar scalar_;
  SurfacePoints points_;
  SpooledParts parts_;
  OutputTarget target_;
  std::uint64_t bytes_written_ = 0;
};

void PlyWriter::write(std::uint64_t /*number*/, const SurfaceChunk& chunk) {
  const auto new_points = points_.take_new(chunk, "PLY");
  ByteSink vertices(std::endian::little, new_points.size() * 3 * scalar_bytes(scalar_));
  for (const std::uint32_t i : new_points) put_point(vertices, chunk.points[i], scalar_);
  parts_.append(kVertices, vertices.bytes());

  ByteSink faces(std::endian::little, chunk.triangles.size() * kFaceBytes);
  for (const auto& triangle : chunk.triangles) {
    faces.put(std::uint8_t{3});
    for (const std::uint32_t corner : triangle) {
      faces.put(static_cast<std::int32_t>(chunk.vertex_numbers[corner]));
    }
  }
  parts_.append(kFaces, faces.bytes());
}

std::string PlyWriter::header() const {
  const std::string type = scalar_ == Scalar::kFloat32 ? "float" : "double";
  std::string text = "ply\nformat binary_little_endian 1.0\ncomment stream-recon\n";
  text += "element vertex " + std::to_string(points_.vertices()) + "\n";
  for (const char* axis : {"x", "y", "z"}) text += "property " + type + " " + axis + "\n";
  text += "element face " + std::to_string(points_.triangles()) + "\n";
  return text + "property list uchar int vertex_indices\nend_header\n";
}

void PlyWriter::complete() {
  const std::string text = header();
  File& file = target_.file();
  file.write(std::as_bytes(std::span(text)));
  parts_.move_to(kVertices, file);
  parts_.move_to(kFaces, file);
  bytes_written_ = file.position();
  target_.prepare();
}

}  // namespace

std::unique_ptr<SurfaceWriter> make_ply_writer(const SurfaceWriterOptions& options) {
  return std::make_unique<PlyWriter>(options);
}

}  // namespace stream_recon
