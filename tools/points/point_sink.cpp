#include "tools/points/point_sink.h"

#include <fmt/format.h>

#include <bit>
#include <iterator>
#include <optional>
#include <stdexcept>

#include "io/atomic_output.h"

namespace stream_recon {
namespace {

constexpr std::size_t kBufferBytes = std::size_t{1} << 16;
static_assert(std::endian::native == std::endian::little, "raw and PLY bytes are little endian");

std::string ply_header(const PointSinkOptions& options) {
  const char* type = options.scalar == Scalar::kFloat32 ? "float" : "double";
  return fmt::format(
      "ply\nformat binary_little_endian 1.0\nelement vertex {}\n"
      "property {} x\nproperty {} y\nproperty {} z\nend_header\n",
      options.count, type, type, type);
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
  return PointFormat::kPly;
}

PointSink::PointSink(const PointSinkOptions& options)
    : options_(options), output_(std::make_unique<Output>(options.path)) {
  if (options_.format == PointFormat::kPly) buffer_ = ply_header(options_);
}

PointSink::~PointSink() = default;

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

void PointSink::finish() {
  if (options_.format == PointFormat::kPly && written_ != options_.count) {
    throw std::logic_error(fmt::format("{} points came for a PLY header of {}: {} is dropped",
                                       written_, options_.count, options_.path));
  }
  output_->write(buffer_);
  buffer_.clear();
  output_->commit();
}

}  // namespace stream_recon
