#include "io/vtk_writer.h"

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

enum Part : std::size_t { kPoints, kPolygons, kDelta, kSource, kClosure, kPointIds, kPartCount };

class VtkWriter final : public SurfaceWriter {
 public:
  explicit VtkWriter(const SurfaceWriterOptions& options)
      : scalar_(options.coordinates),
        has_closure_(options.has_closure),
        parts_(*options.scratch, kPartCount),
        target_(options.path) {}

  bool takes_chunks_in_order() const override { return true; }
  void write(std::uint64_t number, const SurfaceChunk& chunk) override;
  std::uint64_t bytes_written() const override { return bytes_written_; }

 private:
  void complete() override;
  void publish() override { target_.commit(); }
  void write_points(const SurfaceChunk& chunk);
  void write_triangles(const SurfaceChunk& chunk);
  void write_floats(Part part, const std::vector<float>& values);
  void put_text(const std::string& text);

  Scalar scalar_;
  bool has_closure_;
  SurfacePoints points_;
  SpooledParts parts_;
  OutputTarget target_;
  std::uint64_t bytes_written_ = 0;
};

void VtkWriter::write(std::uint64_t /*number*/, const SurfaceChunk& chunk) {
  write_points(chunk);
  write_triangles(chunk);
}

void VtkWriter::write_points(const SurfaceChunk& chunk) {
  const auto new_points = points_.take_new(chunk, "legacy VTK");
  ByteSink coordinates(std::endian::big, new_points.size() * 3 * scalar_bytes(scalar_));
  ByteSink ids(std::endian::big, new_points.size() * sizeof(std::int64_t));
  for (const std::uint32_t i : new_points) {
    put_point(coordinates, chunk.points[i], scalar_);
    ids.put(static_cast<std::int64_t>(chunk.global_ids[i]));
  }
  parts_.append(kPoints, coordinates.bytes());
  parts_.append(kPointIds, ids.bytes());
}

void VtkWriter::write_triangles(const SurfaceChunk& chunk) {
  ByteSink polygons(std::endian::big, chunk.triangles.size() * 4 * sizeof(std::int32_t));
  for (const auto& triangle : chunk.triangles) {
    polygons.put(std::int32_t{3});
    for (const std::uint32_t corner : triangle) {
      polygons.put(static_cast<std::int32_t>(chunk.vertex_numbers[corner]));
    }
  }
  parts_.append(kPolygons, polygons.bytes());
  write_floats(kDelta, chunk.delta);
  parts_.append(kSource, std::as_bytes(std::span(chunk.source)));
  if (has_closure_) write_floats(kClosure, chunk.closure);
}

void VtkWriter::write_floats(Part part, const std::vector<float>& values) {
  ByteSink bytes(std::endian::big, values.size() * sizeof(float));
  for (const float value : values) bytes.put(value);
  parts_.append(part, bytes.bytes());
}

void VtkWriter::put_text(const std::string& text) {
  target_.file().write(std::as_bytes(std::span(text)));
}

void VtkWriter::complete() {
  const std::string vertices = std::to_string(points_.vertices());
  const std::string triangles = std::to_string(points_.triangles());
  const std::string numbers = std::to_string(4 * points_.triangles());
  File& file = target_.file();
  put_text("# vtk DataFile Version 3.0\nstream-recon surface\nBINARY\nDATASET POLYDATA\n");
  put_text("POINTS " + vertices + (scalar_ == Scalar::kFloat32 ? " float\n" : " double\n"));
  parts_.move_to(kPoints, file);
  put_text("\nPOLYGONS " + triangles + " " + numbers + "\n");
  parts_.move_to(kPolygons, file);
  // Fields, because readers take one set of SCALARS and pass over the others.
  put_text("\nCELL_DATA " + triangles + "\nFIELD FieldData " + (has_closure_ ? "3" : "2") +
           "\nDelta 1 " + triangles + " float\n");
  parts_.move_to(kDelta, file);
  put_text("\nSource 1 " + triangles + " unsigned_char\n");
  parts_.move_to(kSource, file);
  if (has_closure_) {
    put_text("\nClosure 1 " + triangles + " float\n");
    parts_.move_to(kClosure, file);
  }
  put_text("\nPOINT_DATA " + vertices + "\nGLOBAL_IDS GlobalPointId vtktypeint64\n");
  parts_.move_to(kPointIds, file);
  put_text("\n");
  bytes_written_ = file.position();
  target_.prepare();
}

}  // namespace

std::unique_ptr<SurfaceWriter> make_vtk_writer(const SurfaceWriterOptions& options) {
  return std::make_unique<VtkWriter>(options);
}

}  // namespace stream_recon
