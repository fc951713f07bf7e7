#include "io/ply_header.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "io/number_text.h"
#include "io/text_reader.h"

namespace stream_recon {
namespace {

constexpr std::size_t kMostProperties = 1024;

std::optional<ScalarType> type_named(std::string_view name) {
  static constexpr std::pair<std::string_view, ScalarType> kNames[] = {
      {"char", ScalarType::kInt8},      {"int8", ScalarType::kInt8},
      {"uchar", ScalarType::kUint8},    {"uint8", ScalarType::kUint8},
      {"short", ScalarType::kInt16},    {"int16", ScalarType::kInt16},
      {"ushort", ScalarType::kUint16},  {"uint16", ScalarType::kUint16},
      {"int", ScalarType::kInt32},      {"int32", ScalarType::kInt32},
      {"uint", ScalarType::kUint32},    {"uint32", ScalarType::kUint32},
      {"int64", ScalarType::kInt64},    {"uint64", ScalarType::kUint64},
      {"float", ScalarType::kFloat32},  {"float32", ScalarType::kFloat32},
      {"double", ScalarType::kFloat64}, {"float64", ScalarType::kFloat64}};
  const auto* found = std::find_if(std::begin(kNames), std::end(kNames),
                                   [&](const auto& entry) { return entry.first == name; });
  if (found == std::end(kNames)) return std::nullopt;
  return found->second;
}

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  for (std::size_t at = line.find_first_not_of(" \t"); at != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(" \t", at), line.size());
    words.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(" \t", end);
  }
  return words;
}

class HeaderParser {
 public:
  explicit HeaderParser(ByteSource& source) : source_(source), text_(source) {}

  PlyHeader parse() {
    std::string_view line;
    if (!text_.next_line(line) || words_of(line) != std::vector<std::string_view>{"ply"}) {
      source_.fail_at(0, "not a PLY file: it does not start with \"ply\"; check --input-format");
    }
    while (next(line)) {
      const std::vector<std::string_view> words = words_of(line);
      if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
      if (words[0] == "end_header") return finish();
      parse_line(words, line);
    }
    text_.fail("the file ends inside the PLY header; it is cut short, fetch it again");
  }

 private:
  bool next(std::string_view& line) {
    if (source_.offset() > kLongestPlyHeader) {
      text_.fail("the PLY header has no end_header within " + std::to_string(kLongestPlyHeader) +
                 " bytes; the file is damaged");
    }
    return text_.next_line(line) && text_.terminated();
  }

  void parse_line(const std::vector<std::string_view>& words, std::string_view line) {
    if (words[0] == "format" && words.size() == 3 && !has_format_) {
      parse_format(words[1], words[2]);
    } else if (words[0] == "element" && words.size() == 3) {
      const std::optional<std::uint64_t> count = whole_count(words[2]);
      if (!count) text_.fail(quote_text(words[2]) + " is no element count; correct the PLY header");
      header_.elements.push_back({std::string(words[1]), *count, {}});
    } else if (words[0] == "property" && !header_.elements.empty() &&
               (words.size() == 3 || (words.size() == 5 && words[1] == "list"))) {
      add_property(words);
    } else {
      text_.fail("unexpected line " + quote_text(line) +
                 " in the PLY header; correct or remove it");
    }
  }

  void parse_format(std::string_view name, std::string_view version) {
    if (name == "ascii") {
      header_.format = PlyFormat::kAscii;
    } else if (name == "binary_little_endian") {
      header_.format = PlyFormat::kBinaryLittleEndian;
    } else if (name == "binary_big_endian") {
      header_.format = PlyFormat::kBinaryBigEndian;
    } else {
      text_.fail("unknown PLY format " + quote_text(name) +
                 "; known are ascii, binary_little_endian, binary_big_endian");
    }
    if (version != "1.0") {
      text_.fail("unknown PLY version " + quote_text(version) + "; only 1.0 exists");
    }
    has_format_ = true;
  }

  void add_property(const std::vector<std::string_view>& words) {
    const auto known = [&](std::string_view name) {
      const std::optional<ScalarType> type = type_named(name);
      if (!type) text_.fail("unknown PLY type " + quote_text(name) + "; correct the header");
      return *type;
    };
    PlyProperty property;
    property.name = words.back();
    property.is_list = words[1] == "list";
    property.type = known(words[words.size() - 2]);
    if (property.is_list) {
      property.count_type = known(words[2]);
      if (is_floating(property.count_type)) {
        text_.fail("the length of list " + quote_text(property.name) +
                   " is no integer; correct the PLY header");
      }
    }
    std::vector<PlyProperty>& properties = header_.elements.back().properties;
    if (properties.size() == kMostProperties) {
      text_.fail("more than " + std::to_string(kMostProperties) +
                 " properties in an element; the PLY header is damaged");
    }
    properties.push_back(std::move(property));
  }

  PlyHeader finish() {
    if (!has_format_) text_.fail("the PLY header has no format line; add one");
    const auto is_vertex = [](const PlyElement& element) { return element.name == "vertex"; };
    std::vector<PlyElement>& elements = header_.elements;
    const auto found = std::find_if(elements.begin(), elements.end(), is_vertex);
    if (found == elements.end()) {
      text_.fail("the PLY header has no element vertex; there are no points to read");
    }
    if (std::count_if(elements.begin(), elements.end(), is_vertex) > 1) {
      text_.fail("the PLY header has more than one element vertex; keep one");
    }
    header_.vertex = static_cast<std::size_t>(found - elements.begin());
    for (std::size_t axis = 0; axis < 3; ++axis) header_.axes[axis] = find_axis("xyz"[axis]);
    header_.lines = text_.line();
    return std::move(header_);
  }

  std::size_t find_axis(char name) const {
    const std::vector<PlyProperty>& properties = header_.vertices().properties;
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < properties.size(); ++i) {
      if (properties[i].name != std::string_view(&name, 1)) continue;
      if (found) text_.fail(std::string("vertex has property ") + name + " twice; rename one");
      found = i;
    }
    if (!found) {
      text_.fail(std::string("vertex has no property ") + name + "; points need x, y and z");
    }
    const PlyProperty& property = properties[*found];
    if (property.is_list || scalar_decoder(property.type, std::endian::native) == nullptr) {
      text_.fail(std::string("property ") + name +
                 " is a list or a 64-bit integer; store it as double");
    }
    return *found;
  }

  ByteSource& source_;
  TextReader text_;
  PlyHeader header_;
  bool has_format_ = false;
};

}  // namespace

bool PlyElement::has_list() const {
  return std::any_of(properties.begin(), properties.end(),
                     [](const PlyProperty& property) { return property.is_list; });
}

std::size_t PlyElement::fixed_size() const {
  std::size_t size = 0;
  for (const PlyProperty& property : properties) size += scalar_size(property.type);
  return size;
}

PlyHeader read_ply_header(ByteSource& source) {
  return HeaderParser(source).parse();
}

}  // namespace stream_recon
