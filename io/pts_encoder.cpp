#include "io/pts_encoder.h"

#include <bit>
#include <cassert>
#include <nlohmann/json.hpp>

#include "io/byte_sink.h"
#include "io/checksum.h"
#include "io/coordinates.h"
#include "io/pts_layout.h"

namespace stream_recon {
namespace {

std::string text_of(const ByteSink& sink) {
  return {reinterpret_cast<const char*>(sink.bytes().data()), sink.bytes().size()};
}

void seal(ByteSink& sink) {
  sink.put(checksum64(sink.bytes()));
}

std::string json_of(const PointMetadata& metadata) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  if (metadata.spacing) json["spacing"] = *metadata.spacing;
  if (!metadata.source.empty()) json["source"] = metadata.source;
  if (!metadata.value.empty()) json["value"] = metadata.value;
  // A file's name may be any bytes.
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace

std::string PtsEncoder::header(const PointMetadata& metadata) const {
  const std::string json = json_of(metadata);
  assert(json.size() <= kPtsMaxMetadata);
  ByteSink sink(std::endian::little, kPtsHeaderBytes + json.size() + kPtsChecksumBytes);
  for (const char c : kPtsMagic) sink.put(c);
  sink.put(kPtsVersion);
  sink.put(static_cast<std::uint32_t>(scalar_bytes(scalar_)));
  sink.put(static_cast<std::uint32_t>(json.size()));
  sink.put(std::uint32_t{0});
  for (const char c : json) sink.put(c);
  seal(sink);
  return text_of(sink);
}

std::string PtsEncoder::frame(std::span<const Point3> points) {
  assert(!points.empty() && points.size() <= kPtsMaxFramePoints);
  ByteSink sink(
      std::endian::little,
      kPtsFrameHeaderBytes + points.size() * 3 * scalar_bytes(scalar_) + kPtsChecksumBytes);
  sink.put(kPtsFrame);
  sink.put(static_cast<std::uint32_t>(points.size()));
  sink.put(points_);
  for (const Point3& p : points) {
    for (const double x : {p.x, p.y, p.z}) {
      if (scalar_ == Scalar::kFloat32) {
        sink.put(static_cast<float>(x));
      } else {
        sink.put(x);
      }
    }
  }
  seal(sink);
  points_ += points.size();
  return text_of(sink);
}

std::string PtsEncoder::end() const {
  ByteSink sink(std::endian::little, kPtsFrameHeaderBytes + kPtsChecksumBytes);
  sink.put(kPtsEnd);
  sink.put(std::uint32_t{0});
  sink.put(points_);
  seal(sink);
  return text_of(sink);
}

}  // namespace stream_recon
