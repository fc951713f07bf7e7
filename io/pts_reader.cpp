#include "io/pts_reader.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "io/checksum.h"
#include "io/pts_layout.h"
#include "io/scalar_type.h"

namespace stream_recon {
namespace {

template <typename Number>
Number number_at(const std::string& bytes, std::size_t offset) {
  return load_scalar<Number>(bytes.data() + offset, std::endian::little);
}

class PtsSource : public PointSource {
 public:
  explicit PtsSource(std::unique_ptr<ByteSource> source) : source_(std::move(source)) {
    read_header();
  }

  std::size_t read(std::span<Point3> out) override {
    std::size_t filled = 0;
    while (filled < out.size() && !ended_) {
      if (next_ == in_frame_) {
        read_frame();
        continue;
      }
      const std::size_t count = std::min<std::size_t>(in_frame_ - next_, out.size() - filled);
      decode(out.subspan(filled, count));
      filled += count;
    }
    return filled;
  }

  const PointMetadata& metadata() const override { return metadata_; }
  std::uint64_t bytes_read() const override { return source_->offset(); }

 private:
  std::size_t point_bytes() const { return 3 * value_bytes_; }

  void decode(std::span<Point3> out) {
    const char* bytes = part_.data() + kPtsFrameHeaderBytes + next_ * point_bytes();
    for (Point3& p : out) {
      p = {decode_(bytes), decode_(bytes + value_bytes_), decode_(bytes + 2 * value_bytes_)};
      bytes += point_bytes();
    }
    next_ += static_cast<std::uint32_t>(out.size());
  }

  /// Appends `count` bytes of the stream to the part.
  void extend(std::size_t count) {
    const std::size_t before = part_.size();
    part_.resize(before + count);
    if (source_->read(std::span(part_).subspan(before)) == count) return;
    source_->fail("the point stream ends without its end frame, after " + std::to_string(points_) +
                  " points; the program that wrote it was stopped, run it again");
  }

  void check(std::uint64_t start, const char* what) const {
    const std::size_t size = part_.size() - kPtsChecksumBytes;
    const auto sum = checksum64(std::as_bytes(std::span(part_)).first(size));
    if (sum == number_at<std::uint64_t>(part_, size)) return;
    source_->fail_at(start, std::string(what) + " of the point stream is damaged; write it again");
  }

  void read_header() {
    extend(kPtsHeaderBytes);
    if (!part_.starts_with(kPtsMagic)) {
      source_->fail_at(0, "no point stream: its first bytes are others; see --input-format");
    }
    const auto version = number_at<std::uint32_t>(part_, 8);
    value_bytes_ = number_at<std::uint32_t>(part_, 12);
    const auto metadata_bytes = number_at<std::uint32_t>(part_, 16);
    if (version != kPtsVersion || (value_bytes_ != 4 && value_bytes_ != 8) ||
        metadata_bytes > kPtsMaxMetadata || number_at<std::uint32_t>(part_, 20) != 0) {
      source_->fail_at(8, "the header of the point stream is damaged, or of a version after " +
                              std::to_string(kPtsVersion) + "; update stream-recon");
    }
    decode_ = scalar_decoder(value_bytes_ == 4 ? ScalarType::kFloat32 : ScalarType::kFloat64,
                             std::endian::little);
    extend(metadata_bytes + kPtsChecksumBytes);
    check(0, "the header");
    take_metadata(part_.substr(kPtsHeaderBytes, metadata_bytes));
  }

  void take_metadata(const std::string& text) {
    try {
      const auto json = nlohmann::json::parse(text);
      metadata_.source = json.value("source", "");
      metadata_.value = json.value("value", "");
      if (!json.contains("spacing")) return;
      metadata_.spacing = json.at("spacing").get<SampleSpacing>();
      for (const double s : *metadata_.spacing) {
        if (!std::isfinite(s) || s <= 0) refuse_metadata();
      }
    } catch (const nlohmann::json::exception&) {
      refuse_metadata();
    }
  }

  [[noreturn]] void refuse_metadata() const {
    source_->fail_at(kPtsHeaderBytes, "the metadata of the point stream is malformed");
  }

  void read_frame() {
    const std::uint64_t start = source_->offset();
    part_.clear();
    extend(kPtsFrameHeaderBytes);
    const auto tag = number_at<std::uint32_t>(part_, 0);
    const auto count = number_at<std::uint32_t>(part_, 4);
    const bool is_end = tag == kPtsEnd && count == 0;
    const bool is_frame = tag == kPtsFrame && count > 0 && count <= kPtsMaxFramePoints;
    if ((!is_end && !is_frame) || number_at<std::uint64_t>(part_, 8) != points_) {
      source_->fail_at(start, "no frame of a point stream begins here; the stream is damaged");
    }
    extend(count * point_bytes() + kPtsChecksumBytes);
    check(start, "a frame");
    next_ = 0;
    in_frame_ = count;
    points_ += count;
    if (is_end) end();
  }

  void end() {
    ended_ = true;
    if (!source_->peek(1).empty()) {
      source_->fail("the point stream has ended but bytes follow; give each stream as one input");
    }
  }

  std::unique_ptr<ByteSource> source_;
  PointMetadata metadata_;
  ScalarDecoder decode_ = nullptr;
  std::size_t value_bytes_ = 0;
  std::string part_;            ///< the header, then a frame, as it lies in the stream
  std::uint32_t in_frame_ = 0;  ///< points of the frame
  std::uint32_t next_ = 0;      ///< first of them not yet delivered
  std::uint64_t points_ = 0;    ///< up to the end of the frame
  bool ended_ = false;
};

}  // namespace

std::unique_ptr<PointSource> make_pts_source(std::unique_ptr<ByteSource> source) {
  return std::make_unique<PtsSource>(std::move(source));
}

}  // namespace stream_recon
