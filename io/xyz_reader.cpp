#include "io/xyz_reader.h"

#include <algorithm>
#include <array>
#include <utility>

#include "io/number_text.h"
#include "io/text_reader.h"
#include "io/xyz_columns.h"

namespace stream_recon {
namespace {

using Axes = std::array<std::size_t, 3>;
constexpr Axes kFirstColumns{0, 1, 2};

class XyzSource : public PointSource {
 public:
  explicit XyzSource(std::unique_ptr<ByteSource> source)
      : source_(std::move(source)), text_(*source_) {
    if (source_->peek(3).starts_with("\xEF\xBB\xBF")) source_->consume(3);
    read_first_lines();
  }

  std::size_t read(std::span<Point3> out) override {
    std::size_t filled = 0;
    if (first_ && !out.empty()) out[filled++] = *std::exchange(first_, std::nullopt);
    std::string_view line;
    while (filled < out.size() && next_content(line)) {
      out[filled++] = parse_point(line);
      if (!text_.terminated()) check_last(line);
    }
    done_ += filled;
    if (announced_ && (done_ > *announced_ || (filled == 0 && done_ < *announced_))) fail_count();
    return filled;
  }

  std::optional<std::uint64_t> announced_count() const override { return announced_; }
  std::uint64_t bytes_read() const override { return source_->offset(); }

 private:
  /// Takes the next line that is neither empty nor a comment, with its blanks at the front.
  bool next_content(std::string_view& line) {
    while (text_.next_line(line)) {
      const std::size_t begin = line.find_first_not_of(" \t");
      if (begin == std::string_view::npos) continue;
      if (line[begin] != '#' && !line.substr(begin).starts_with("//")) return true;
      if (!first_found_) last_comment_ = line.substr(begin + (line[begin] == '#' ? 1 : 2));
    }
    return false;
  }

  /// Settles count, columns and separator, and parses the first point.
  void read_first_lines() {
    std::string_view line;
    bool has_line = next_content(line);
    if (has_line) {
      announced_ = whole_count(without_comment(line));
      if (announced_) has_line = next_content(line);
    }
    const bool named = has_line && is_line_of_names(line);
    if (named) {
      take_names(line);
      has_line = next_content(line);
    }
    first_found_ = true;
    if (!has_line) return;
    const std::string_view content = without_comment(line);
    const std::optional<XyzSeparator> separator = separator_of(content);
    if (!separator) {
      text_.fail("both ',' and ';' stand in the line; write decimal points and one separator");
    }
    separator_ = *separator;
    column_count_ = count_columns(content, separator_);
    if (!named) take_names_of_comment();
    first_ = parse_point(line);
    if (!text_.terminated()) check_last(line);
  }

  static bool is_line_of_names(std::string_view line) {
    line = without_comment(line);
    std::string_view column;
    const XyzSeparator separator = separator_of(line).value_or(XyzSeparator::kSemicolon);
    return take_column(line, separator, column) && !column.empty() &&
           std::string_view("+-.0123456789").find(column.front()) == std::string_view::npos &&
           !whole_double(column);
  }

  void take_names(std::string_view line) {
    const std::optional<Axes> axes = named_axes(without_comment(line));
    if (!axes) {
      text_.fail("the first line " + quote_text(line) +
                 " is neither numbers nor names of columns x, y, z; name them, or put # in front");
    }
    axes_ = *axes;
  }

  void take_names_of_comment() {
    const std::optional<Axes> axes = named_axes(last_comment_);
    const XyzSeparator separator = separator_of(last_comment_).value_or(XyzSeparator::kSemicolon);
    if (axes && count_columns(last_comment_, separator) == column_count_) axes_ = *axes;
  }

  Point3 parse_point(std::string_view line) const {
    return axes_ == kFirstColumns ? parse_first_columns(line) : parse_named_columns(line);
  }

  Point3 parse_first_columns(std::string_view line) const {
    const char* at = line.data();
    const char* end = at + line.size();
    const auto separator = static_cast<char>(separator_);
    std::array<double, 3> point;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      while (at != end && is_blank(*at)) ++at;
      const char* stop = parse_double(at, end, point[axis]);
      if (stop == nullptr || (stop != end && !is_blank(*stop) && *stop != separator)) {
        fail_column(line, axis);
      }
      at = stop;
      if (axis == 2 || separator_ == XyzSeparator::kBlank) continue;
      while (at != end && is_blank(*at)) ++at;
      if (at == end || *at != separator) fail_column(line, axis + 1);
      ++at;
    }
    return {point[0], point[1], point[2]};
  }

  Point3 parse_named_columns(std::string_view line) const {
    std::array<double, 3> point{};
    const std::size_t last = *std::max_element(axes_.begin(), axes_.end());
    std::string_view rest = line;
    std::string_view column;
    for (std::size_t i = 0; i <= last; ++i) {
      if (!take_column(rest, separator_, column)) fail_column(line, i);
      const auto axis = std::find(axes_.begin(), axes_.end(), i);
      if (axis == axes_.end()) continue;
      const std::optional<double> value = whole_double(column);
      if (!value) fail_column(line, i);
      point[static_cast<std::size_t>(axis - axes_.begin())] = *value;
    }
    return {point[0], point[1], point[2]};
  }

  static bool is_blank(char c) { return c == ' ' || c == '\t'; }

  [[noreturn]] void fail_column(std::string_view line, std::size_t index) const {
    std::string_view rest = without_comment(line);
    std::string_view column;
    for (std::size_t i = 0; i <= index; ++i) {
      if (!take_column(rest, separator_, column)) {
        text_.fail(std::to_string(i) + " columns, too few for x, y and z; correct the line");
      }
    }
    const std::string shown = column.empty() ? "an empty column" : quote_text(column);
    text_.fail(shown + " where column " + std::to_string(index + 1) +
               " should be a number; correct the line, or put # in front of a comment");
  }

  /// The last line has no line end: what can be missing, must not be.
  void check_last(std::string_view line) const {
    if (announced_ || count_columns(without_comment(line), separator_) < column_count_) {
      text_.fail(
          "no line end behind the last point, so digits may be missing; fetch the file again, or "
          "add the line end if it is whole");
    }
  }

  [[noreturn]] void fail_count() const {
    text_.fail((done_ > *announced_ ? "more points than" : "the file ends before") +
               std::string(" the ") + std::to_string(*announced_) +
               " points its first line announces; correct the count or fetch the file again");
  }

  std::unique_ptr<ByteSource> source_;
  TextReader text_;
  Axes axes_ = kFirstColumns;
  XyzSeparator separator_ = XyzSeparator::kBlank;
  std::size_t column_count_ = 0;  ///< of the first point
  std::string last_comment_;      ///< before the first point
  bool first_found_ = false;
  std::optional<Point3> first_;
  std::optional<std::uint64_t> announced_;
  std::uint64_t done_ = 0;
};

}  // namespace

std::unique_ptr<PointSource> make_xyz_source(std::unique_ptr<ByteSource> source) {
  return std::make_unique<XyzSource>(std::move(source));
}

}  // namespace stream_recon
