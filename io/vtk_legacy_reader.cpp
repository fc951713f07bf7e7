#include "io/vtk_legacy_reader.h"

#include <algorithm>
#include <array>
#include <utility>

#include "io/number_text.h"
#include "io/text_reader.h"
#include "io/vtk_legacy_header.h"

namespace stream_recon {
namespace {

class VtkLegacySource : public PointSource {
 public:
  explicit VtkLegacySource(std::unique_ptr<ByteSource> source)
      : source_(std::move(source)),
        text_(*source_),
        header_(read_vtk_legacy_header(*source_, text_)),
        decode_(scalar_decoder(header_.type, std::endian::big)),
        value_size_(scalar_size(header_.type)) {}

  std::size_t read(std::span<Point3> out) override {
    const std::uint64_t left = header_.points - done_;
    out = out.first(static_cast<std::size_t>(std::min<std::uint64_t>(out.size(), left)));
    if (left == 0) check_end();
    return header_.binary ? read_binary(out) : read_ascii(out);
  }

  std::optional<std::uint64_t> announced_count() const override { return header_.points; }
  std::uint64_t bytes_read() const override { return source_->offset(); }

 private:
  std::size_t read_ascii(std::span<Point3> out) {
    for (Point3& point : out) {
      point.x = take_number();
      point.y = take_number();
      point.z = take_number();
      ++done_;
    }
    return out.size();
  }

  double take_number() {
    const std::string_view word = text_.next_word();
    if (word.empty()) fail_short();
    const std::optional<double> value =
        header_.type == ScalarType::kFloat32 ? whole_float(word) : whole_double(word);
    if (!value) {
      text_.fail(quote_text(word) + " is no number, in point " + std::to_string(done_) + " of " +
                 std::to_string(header_.points) + "; correct it or the count of POINTS");
    }
    if (!text_.terminated()) {
      text_.fail(
          "no line end behind the last number, so digits may be missing; fetch the file again, or "
          "add the line end if it is whole");
    }
    return *value;
  }

  std::size_t read_binary(std::span<Point3> out) {
    const std::size_t point_size = 3 * value_size_;
    std::size_t filled = 0;
    while (filled < out.size()) {
      const std::string_view ready = source_->peek(point_size);
      const std::size_t points = std::min(ready.size() / point_size, out.size() - filled);
      if (points == 0) fail_short();
      const char* bytes = ready.data();
      for (std::size_t i = 0; i < points; ++i, bytes += point_size) {
        out[filled + i] = {decode_(bytes), decode_(bytes + value_size_),
                           decode_(bytes + 2 * value_size_)};
      }
      source_->consume(points * point_size);
      filled += points;
      done_ += points;
    }
    return filled;
  }

  /// Behind the points stands a keyword or the end; anything else means the count is wrong.
  void check_end() {
    for (std::string_view rest = source_->peek(1); !rest.empty(); rest = source_->peek(1)) {
      const std::size_t next = rest.find_first_not_of(" \t\r\n");
      source_->consume(std::min(next, rest.size()));
      if (next == std::string_view::npos) continue;
      const char c = rest[next];
      if ((c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z')) return;
      source_->fail("no keyword behind the " + std::to_string(header_.points) +
                    " points; correct the count or the type of POINTS");
    }
  }

  [[noreturn]] void fail_short() const {
    source_->fail("the file ends inside point " + std::to_string(done_) + " of " +
                  std::to_string(header_.points) + "; it is cut short, fetch it again");
  }

  std::unique_ptr<ByteSource> source_;
  TextReader text_;
  VtkLegacyHeader header_;
  ScalarDecoder decode_;
  std::size_t value_size_;
  std::uint64_t done_ = 0;
};

}  // namespace

std::unique_ptr<PointSource> make_vtk_legacy_source(std::unique_ptr<ByteSource> source) {
  return std::make_unique<VtkLegacySource>(std::move(source));
}

}  // namespace stream_recon
