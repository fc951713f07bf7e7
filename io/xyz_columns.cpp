#include "io/xyz_columns.h"

namespace stream_recon {
namespace {

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t";
  const std::size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return text.substr(text.size());
  return text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

std::optional<std::size_t> axis_named(std::string_view name) {
  if (name.size() > 2 && name.front() == '"' && name.back() == '"') {
    name = name.substr(1, name.size() - 2);
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (name == std::string_view("xyz").substr(axis, 1) ||
        name == std::string_view("XYZ").substr(axis, 1) ||
        (name.starts_with("Points:") &&
         name.substr(7) == std::string_view("012").substr(axis, 1))) {
      return axis;
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<XyzSeparator> separator_of(std::string_view line) {
  const bool comma = line.find(',') != std::string_view::npos;
  const bool semicolon = line.find(';') != std::string_view::npos;
  if (comma && semicolon) return std::nullopt;
  if (comma) return XyzSeparator::kComma;
  return semicolon ? XyzSeparator::kSemicolon : XyzSeparator::kBlank;
}

std::string_view without_comment(std::string_view line) {
  line = line.substr(0, line.find('#'));
  return trimmed(line.substr(0, line.find("//")));
}

bool take_column(std::string_view& rest, XyzSeparator separator, std::string_view& column) {
  rest = trimmed(rest);
  if (rest.empty()) return false;
  const bool blank = separator == XyzSeparator::kBlank;
  const std::size_t end =
      blank ? rest.find_first_of(" \t") : rest.find(static_cast<char>(separator));
  column = trimmed(rest.substr(0, end));
  rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
  return true;
}

std::size_t count_columns(std::string_view line, XyzSeparator separator) {
  std::size_t count = 0;
  for (std::string_view column; take_column(line, separator, column);) ++count;
  return count;
}

std::optional<std::array<std::size_t, 3>> named_axes(std::string_view line) {
  const XyzSeparator separator = separator_of(line).value_or(XyzSeparator::kSemicolon);
  std::array<std::optional<std::size_t>, 3> found;
  std::string_view name;
  for (std::size_t i = 0; take_column(line, separator, name); ++i) {
    const std::optional<std::size_t> axis = axis_named(name);
    if (!axis) continue;
    if (found[*axis]) return std::nullopt;
    found[*axis] = i;
  }
  if (!found[0] || !found[1] || !found[2]) return std::nullopt;
  return std::array<std::size_t, 3>{*found[0], *found[1], *found[2]};
}

}  // namespace stream_recon
