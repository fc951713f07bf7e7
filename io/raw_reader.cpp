#include "io/raw_reader.h"

#include <algorithm>
#include <utility>

namespace stream_recon {
namespace {

class RawSource : public PointSource {
 public:
  RawSource(std::unique_ptr<ByteSource> source, ScalarType type)
      : source_(std::move(source)),
        decode_(scalar_decoder(type, std::endian::little)),
        value_size_(scalar_size(type)) {
    if (const auto size = source_->size(); size && *size % point_size() != 0) {
      fail_size(*size - *size % point_size());
    }
  }

  std::size_t read(std::span<Point3> out) override {
    std::size_t filled = 0;
    while (filled < out.size()) {
      const std::string_view ready = source_->peek(point_size());
      const std::size_t points = std::min(ready.size() / point_size(), out.size() - filled);
      if (points == 0) {
        if (!ready.empty()) fail_size(source_->offset());
        break;
      }
      const char* bytes = ready.data();
      for (std::size_t i = 0; i < points; ++i, bytes += point_size()) {
        out[filled + i] = {decode_(bytes), decode_(bytes + value_size_),
                           decode_(bytes + 2 * value_size_)};
      }
      source_->consume(points * point_size());
      filled += points;
    }
    return filled;
  }

  std::optional<std::uint64_t> announced_count() const override {
    if (!source_->size()) return std::nullopt;
    return *source_->size() / point_size();
  }
  std::uint64_t bytes_read() const override { return source_->offset(); }

 private:
  std::size_t point_size() const { return 3 * value_size_; }

  [[noreturn]] void fail_size(std::uint64_t byte) const {
    source_->fail_at(byte, "the input ends inside a point of " + std::to_string(point_size()) +
                               " bytes; it is cut short, or not of this number type");
  }

  std::unique_ptr<ByteSource> source_;
  ScalarDecoder decode_;
  std::size_t value_size_;
};

}  // namespace

std::unique_ptr<PointSource> make_raw_source(std::unique_ptr<ByteSource> source, ScalarType type) {
  return std::make_unique<RawSource>(std::move(source), type);
}

}  // namespace stream_recon
