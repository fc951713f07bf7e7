#include "io/vtp_reader.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/scalar_type.h"
#include "io/vtp_array_reader.h"

namespace stream_recon {
namespace {

constexpr std::size_t kBufferedPoints = 2048;

class VtpSource : public PointSource {
 public:
  explicit VtpSource(std::unique_ptr<ByteSource> source)
      : source_(std::move(source)), arrays_(*source_, [](const VtpArray& array) {
          return array.section == VtpSection::kPoints;
        }) {
    next_array();
    if (!array_) {
      announced_ = 0;
    } else if (array_->storage == VtpStorage::kAppended && !inline_met_) {
      announced_ = 0;
      for (const VtpArray& array : arrays_.appended()) *announced_ += array.piece.points;
    }
  }

  std::size_t read(std::span<Point3> out) override {
    std::size_t filled = 0;
    while (filled < out.size() && array_) {
      const std::uint64_t left = array_->piece.points - done_;
      if (left == 0) {
        finish_array();
        continue;
      }
      const std::size_t count = static_cast<std::size_t>(
          std::min<std::uint64_t>({left, out.size() - filled, kBufferedPoints}));
      decode(out.subspan(filled, count));
      filled += count;
      done_ += count;
    }
    return filled;
  }

  std::optional<std::uint64_t> announced_count() const override { return announced_; }
  std::uint64_t bytes_read() const override { return source_->offset(); }

 private:
  void next_array() {
    array_ = arrays_.next();
    done_ = 0;
    if (!array_) return;
    inline_met_ = inline_met_ || array_->storage != VtpStorage::kAppended;
    decoder_ = scalar_decoder(array_->type, arrays_.order());
    if (array_->components != 3 || decoder_ == nullptr) {
      source_->fail("points of " + std::to_string(array_->components) +
                    " components or of 64-bit integers; store them as 3 components of Float64");
    }
    value_size_ = scalar_size(array_->type);
    buffer_.resize(kBufferedPoints * 3 * value_size_);
  }

  void decode(std::span<Point3> out) {
    const std::size_t bytes = out.size() * 3 * value_size_;
    const std::size_t got = arrays_.read({buffer_.data(), bytes});
    if (got != bytes) {
      source_->fail("the points end inside point " +
                    std::to_string(done_ + got / (3 * value_size_)) + " of " +
                    std::to_string(array_->piece.points) + "; the file is damaged");
    }
    const char* at = buffer_.data();
    for (Point3& point : out) {
      point = {decoder_(at), decoder_(at + value_size_), decoder_(at + 2 * value_size_)};
      at += 3 * value_size_;
    }
  }

  /// A piece without points may leave out its array's content, so nothing is read then.
  void finish_array() {
    if (array_->piece.points != 0 && arrays_.read({buffer_.data(), value_size_}) != 0) {
      source_->fail("more points than the " + std::to_string(array_->piece.points) +
                    " its piece announces; correct NumberOfPoints");
    }
    next_array();
  }

  std::unique_ptr<ByteSource> source_;
  VtpArrayReader arrays_;
  std::optional<VtpArray> array_;
  ScalarDecoder decoder_ = nullptr;
  std::size_t value_size_ = 0;
  std::uint64_t done_ = 0;  ///< points of the current array
  bool inline_met_ = false;
  std::optional<std::uint64_t> announced_;
  std::vector<char> buffer_;
};

}  // namespace

std::unique_ptr<PointSource> make_vtp_source(std::unique_ptr<ByteSource> source) {
  return std::make_unique<VtpSource>(std::move(source));
}

}  // namespace stream_recon
