#include "tools/points/point_sink.h"

#include <fmt/format.h>

#include <bit>
#include <cassert>
#include <iterator>
#include <optional>
#include <stdexcept>

#include "io/atomic_output.h"

namespace stream_recon {
namespace {

constexpr std::size_t kBufferBytes = std::size_t{1} << 16;
static_assert(std::endian::native == std::endian::little, "raw and PLY bytes are little endian");

constexpr std::size_t kFramePoints = std::size_t{1} << 14;
constexpr std::size_t kMostDigits = 20;  // of a count of 64 bits

// Where the count comes last, a comment takes up the room that its digits leave.
std::string ply_header(Scalar scalar, std::uint64_t count, bool padded) {
  const char* type = scalar == Scalar::kFloat32 ? "float" : "double";
  const std::string digits = std::to_string(count);
  const std::string padding =
      padded ? fmt::format("comment {}\n", std::string(kMostDigits + 1 - digits.size(), '-')) : "";
  return fmt::format(
      "ply\nformat binary_little_endian 1.0\n{}element vertex {}\n"
      "property {} x\nproperty {} y\nproperty {} z\nend_header\n",
      padding, digits, type, type, type);
}

}  // namespace

/// A file that is complete or not there, or standard output.
class PointSink::Output {
 public:
  explicit Output(const std::string& path) {
    if (path == "-") {
      stream_ = File::standard_output();
    } else {
      file_.emplace(path);
    }
  }
  void write(const std::string& bytes) {
    (file_ ? file_->file() : stream_).write(std::as_bytes(std::span(bytes)));
  }
  void write_at_start(const std::string& bytes) {
    file_.value().file().write_at(0, std::as_bytes(std::span(bytes)));
  }
  void commit() {
    if (file_) file_->commit();
  }

 private:
  std::optional<AtomicOutput> file_;
  File stream_;
};

PointFormat point_format_of(const std::string& path) {
  if (path.ends_with(".xyz") || path.ends_with(".txt")) return PointFormat::kXyz;
  if (path.ends_with(".f32")) return PointFormat::kF32;
  if (path.ends_with(".f64")) return PointFormat::kF64;
  if (path.ends_with(".pts")) return PointFormat::kPts;
  return PointFormat::kPly;
}

PointSink::PointSink(const PointSinkOptions& options)
    : options_(options), output_(std::make_unique<Output>(options.path)), frames_(options.scalar) {
  if (options_.format == PointFormat::kPly) {
    assert(options_.count || options_.path != "-");
    buffer_ = ply_header(options_.scalar, options_.count.value_or(0), !options_.count);
  }
  if (options_.format == PointFormat::kPts) buffer_ = frames_.header(options_.metadata);
}

PointSink::~PointSink() = default;
PointSink::PointSink(PointSink&&) noexcept = default;
PointSink& PointSink::operator=(PointSink&&) noexcept = default;

template <typename Real>
void PointSink::put_binary(const Point3& p) {
  const Real values[3] = {static_cast<Real>(p.x), static_cast<Real>(p.y), static_cast<Real>(p.z)};
  buffer_.append(reinterpret_cast<const char*>(values), sizeof values);
}

void PointSink::put(const Point3& p) {
  switch (options_.format) {
    case PointFormat::kXyz:
      fmt::format_to(std::back_inserter(buffer_), "{} {} {}\n", p.x, p.y, p.z);
      return;
    case PointFormat::kF32:
      return put_binary<float>(p);
    case PointFormat::kF64:
      return put_binary<double>(p);
    case PointFormat::kPts:
      frame_.push_back(p);
      if (frame_.size() == kFramePoints) put_frame();
      return;
    case PointFormat::kPly:
      break;
  }
  if (options_.scalar == Scalar::kFloat32) return put_binary<float>(p);
  put_binary<double>(p);
}

void PointSink::write(std::span<const Point3> points) {
  for (const Point3& p : points) {
    put(p);
    if (buffer_.size() < kBufferBytes) continue;
    output_->write(buffer_);
    buffer_.clear();
  }
  written_ += points.size();
}

void PointSink::put_frame() {
  if (frame_.empty()) return;
  buffer_ += frames_.frame(frame_);
  frame_.clear();
}

void PointSink::finish_ply() {
  if (!options_.count) {
    output_->write_at_start(ply_header(options_.scalar, written_, true));
  } else if (written_ != *options_.count) {
    throw std::logic_error(fmt::format("{} points came for a PLY header of {}: {} is dropped",
                                       written_, *options_.count, options_.path));
  }
}

void PointSink::finish() {
  if (options_.format == PointFormat::kPts) {
    put_frame();
    buffer_ += frames_.end();
  }
  output_->write(buffer_);
  buffer_.clear();
  if (options_.format == PointFormat::kPly) finish_ply();
  output_->commit();
}

}  // namespace stream_recon
