#include <algorithm>
#include <array>
#include <utility>

#include "io/ply_body.h"

namespace stream_recon {
namespace {

class PlyBinarySource : public PointSource {
 public:
  PlyBinarySource(std::unique_ptr<ByteSource> source, const PlyHeader& header)
      : source_(std::move(source)),
        order_(header.format == PlyFormat::kBinaryBigEndian ? std::endian::big
                                                            : std::endian::little),
        vertices_(header.vertices()),
        axes_(header.axes),
        vertices_last_(header.vertex + 1 == header.elements.size()),
        has_list_(vertices_.has_list()),
        record_size_(has_list_ ? 0 : vertices_.fixed_size()) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto property = vertices_.properties.begin() + static_cast<long>(axes_[axis]);
      decoders_[axis] = scalar_decoder(property->type, order_);
      for (auto before = vertices_.properties.begin(); before != property; ++before) {
        offsets_[axis] += scalar_size(before->type);
      }
    }
    for (std::size_t i = 0; i < header.vertex; ++i) skip_element(header.elements[i]);
  }

  std::size_t read(std::span<Point3> out) override {
    const std::uint64_t left = vertices_.count - done_;
    out = out.first(static_cast<std::size_t>(std::min<std::uint64_t>(out.size(), left)));
    if (left == 0) check_end();
    return has_list_ ? read_variable(out) : read_fixed(out);
  }

  std::optional<std::uint64_t> announced_count() const override { return vertices_.count; }
  std::uint64_t bytes_read() const override { return source_->offset(); }

 private:
  std::size_t read_fixed(std::span<Point3> out) {
    std::size_t filled = 0;
    while (filled < out.size()) {
      const std::string_view ready = source_->peek(record_size_);
      const std::size_t records = std::min(ready.size() / record_size_, out.size() - filled);
      if (records == 0) fail_short();
      const char* record = ready.data();
      for (std::size_t i = 0; i < records; ++i, record += record_size_) {
        out[filled + i] = {decoders_[0](record + offsets_[0]), decoders_[1](record + offsets_[1]),
                           decoders_[2](record + offsets_[2])};
      }
      source_->consume(records * record_size_);
      filled += records;
      done_ += records;
    }
    return filled;
  }

  std::size_t read_variable(std::span<Point3> out) {
    for (Point3& point : out) {
      std::array<double, 3> values{};
      for (std::size_t i = 0; i < vertices_.properties.size(); ++i) {
        const PlyProperty& property = vertices_.properties[i];
        const auto axis = std::find(axes_.begin(), axes_.end(), i);
        if (axis == axes_.end()) {
          if (!skip_property(property)) fail_short();
          continue;
        }
        const std::size_t size = scalar_size(property.type);
        const std::string_view ready = source_->peek(size);
        if (ready.size() < size) fail_short();
        const auto position = static_cast<std::size_t>(axis - axes_.begin());
        values[position] = decoders_[position](ready.data());
        source_->consume(size);
      }
      point = {values[0], values[1], values[2]};
      ++done_;
    }
    return out.size();
  }

  /// False where the file ends within it.
  bool skip_property(const PlyProperty& property) {
    std::uint64_t bytes = scalar_size(property.type);
    if (property.is_list) {
      const std::size_t size = scalar_size(property.count_type);
      const std::string_view ready = source_->peek(size);
      if (ready.size() < size) return false;
      bytes *= list_length(property, ready.data());
      source_->consume(size);
    }
    return source_->skip(bytes) == bytes;
  }

  std::uint64_t list_length(const PlyProperty& property, const char* bytes) const {
    constexpr std::uint64_t kMost = std::uint64_t{1} << 60;
    std::uint64_t length = kMost;
    if (const ScalarDecoder decode = scalar_decoder(property.count_type, order_)) {
      const double value = decode(bytes);
      if (value >= 0) length = static_cast<std::uint64_t>(value);
    } else {
      length = load_scalar<std::uint64_t>(bytes, order_);
    }
    if (length >= kMost) {
      source_->fail("list " + property.name +
                    " has an impossible length; the file is damaged or its header is wrong");
    }
    return length;
  }

  void skip_element(const PlyElement& element) {
    if (element.properties.empty()) return;
    bool complete = true;
    if (!element.has_list()) {
      const std::uint64_t size = element.fixed_size();
      complete = element.count <= UINT64_MAX / size &&
                 source_->skip(element.count * size) == element.count * size;
    }
    for (std::uint64_t i = 0; element.has_list() && complete && i < element.count; ++i) {
      for (const PlyProperty& property : element.properties) {
        complete = complete && skip_property(property);
      }
    }
    if (!complete) {
      source_->fail("the file ends inside element " + element.name +
                    ", before the vertices; it is cut short, fetch it again");
    }
  }

  [[noreturn]] void fail_short() const {
    source_->fail("the file ends inside vertex " + std::to_string(done_) + " of " +
                  std::to_string(vertices_.count) + "; it is cut short, fetch it again");
  }

  void check_end() {
    if (!vertices_last_) return;
    for (std::string_view rest = source_->peek(1); !rest.empty(); rest = source_->peek(1)) {
      const std::size_t other = rest.find_first_not_of(" \t\r\n");
      if (other != std::string_view::npos) {
        source_->fail_at(source_->offset() + other,
                         "bytes follow the last of the " + std::to_string(vertices_.count) +
                             " vertices; correct the count or the properties in the PLY header");
      }
      source_->consume(rest.size());
    }
  }

  std::unique_ptr<ByteSource> source_;
  std::endian order_;
  PlyElement vertices_;
  std::array<std::size_t, 3> axes_;
  bool vertices_last_;
  bool has_list_;
  std::size_t record_size_;
  std::array<std::size_t, 3> offsets_{};
  std::array<ScalarDecoder, 3> decoders_{};
  std::uint64_t done_ = 0;
};

}  // namespace

std::unique_ptr<PointSource> make_ply_binary_body(std::unique_ptr<ByteSource> source,
                                                  const PlyHeader& header) {
  return std::make_unique<PlyBinarySource>(std::move(source), header);
}

}  // namespace stream_recon
