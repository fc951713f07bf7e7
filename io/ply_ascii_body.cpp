#include <algorithm>
#include <array>
#include <utility>

#include "io/number_text.h"
#include "io/ply_body.h"
#include "io/text_reader.h"

namespace stream_recon {
namespace {

constexpr bool is_blank(char c) {
  return c == ' ' || c == '\t';
}

class PlyAsciiSource : public PointSource {
 public:
  PlyAsciiSource(std::unique_ptr<ByteSource> source, const PlyHeader& header)
      : source_(std::move(source)),
        text_(*source_, header.lines),
        vertices_(header.vertices()),
        axes_(header.axes),
        vertices_last_(header.vertex + 1 == header.elements.size()) {
    for (std::size_t i = 0; i < header.vertex; ++i) skip_element(header.elements[i]);
  }

  std::size_t read(std::span<Point3> out) override {
    const std::uint64_t left = vertices_.count - done_;
    out = out.first(static_cast<std::size_t>(std::min<std::uint64_t>(out.size(), left)));
    if (left == 0 && vertices_last_) check_end();
    for (Point3& point : out) {
      std::string_view line;
      if (!next_filled_line(line)) fail_short();
      point = parse_vertex(line);
      if (!text_.terminated()) {
        text_.fail(
            "no line end behind the last vertex, so digits may be missing; fetch the file again, "
            "or add the line end if it is whole");
      }
      ++done_;
    }
    return out.size();
  }

  std::optional<std::uint64_t> announced_count() const override { return vertices_.count; }
  std::uint64_t bytes_read() const override { return source_->offset(); }

 private:
  bool next_filled_line(std::string_view& line) {
    while (text_.next_line(line)) {
      if (line.find_first_not_of(" \t") != std::string_view::npos) return true;
    }
    return false;
  }

  Point3 parse_vertex(std::string_view line) const {
    std::array<double, 3> point{};
    for (std::size_t i = 0; i < vertices_.properties.size(); ++i) {
      const PlyProperty& property = vertices_.properties[i];
      const auto axis = std::find(axes_.begin(), axes_.end(), i);
      if (property.is_list) {
        skip_list(line);
      } else if (axis == axes_.end()) {
        take_word(line);
      } else {
        point[static_cast<std::size_t>(axis - axes_.begin())] = take_number(line, property.type);
      }
    }
    if (line.find_first_not_of(" \t") != std::string_view::npos) {
      text_.fail("more values than a vertex has properties; correct the line or the PLY header");
    }
    return {point[0], point[1], point[2]};
  }

  std::string_view take_word(std::string_view& line) const {
    std::size_t begin = 0;
    while (begin < line.size() && is_blank(line[begin])) ++begin;
    std::size_t end = begin;
    while (end < line.size() && !is_blank(line[end])) ++end;
    if (begin == end) fail_few();
    const std::string_view word = line.substr(begin, end - begin);
    line.remove_prefix(end);
    return word;
  }

  double take_number(std::string_view& line, ScalarType type) const {
    while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
    const char* end = line.data() + line.size();
    double value = 0;
    const char* stop = type == ScalarType::kFloat32 ? parse_float(line.data(), end, value)
                                                    : parse_double(line.data(), end, value);
    if (stop == nullptr || (stop != end && !is_blank(*stop))) {
      if (line.empty()) fail_few();
      text_.fail(quote_text(take_word(line)) + " is no number; correct the line or the PLY header");
    }
    line.remove_prefix(static_cast<std::size_t>(stop - line.data()));
    return value;
  }

  void skip_list(std::string_view& line) const {
    const std::string_view word = take_word(line);
    const std::optional<std::uint64_t> length = whole_count(word);
    if (!length) text_.fail(quote_text(word) + " is no list length; correct the line");
    for (std::uint64_t i = 0; i < *length; ++i) take_word(line);
  }

  void skip_element(const PlyElement& element) {
    if (element.properties.empty()) return;
    for (std::uint64_t i = 0; i < element.count;) {
      const std::string_view next = source_->peek(2);
      const bool blank = next.starts_with('\n') || next.starts_with("\r\n");
      if (!text_.skip_line()) {
        text_.fail("the file ends inside element " + element.name +
                   ", before the vertices; it is cut short, fetch it again");
      }
      if (!blank) ++i;
    }
  }

  [[noreturn]] void fail_few() const {
    text_.fail("fewer values than a vertex has properties; correct the line or the PLY header");
  }

  [[noreturn]] void fail_short() const {
    text_.fail("the file ends after vertex " + std::to_string(done_) + " of " +
               std::to_string(vertices_.count) + "; it is cut short, fetch it again");
  }

  void check_end() {
    std::string_view line;
    if (next_filled_line(line)) {
      text_.fail("more lines than the " + std::to_string(vertices_.count) +
                 " vertices of the header; correct the count in the PLY header");
    }
  }

  std::unique_ptr<ByteSource> source_;
  TextReader text_;
  PlyElement vertices_;
  std::array<std::size_t, 3> axes_;
  bool vertices_last_;
  std::uint64_t done_ = 0;
};

}  // namespace

std::unique_ptr<PointSource> make_ply_ascii_body(std::unique_ptr<ByteSource> source,
                                                 const PlyHeader& header) {
  return std::make_unique<PlyAsciiSource>(std::move(source), header);
}

}  // namespace stream_recon
