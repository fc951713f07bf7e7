#include "io/vtk_legacy_header.h"

#include <array>
#include <optional>
#include <string>

#include "io/number_text.h"
#include "io/vtk_legacy_scanner.h"

namespace stream_recon {
namespace {

class HeaderParser {
 public:
  HeaderParser(ByteSource& source, TextReader& text)
      : source_(source), text_(text), scanner_(source, text) {}

  VtkLegacyHeader parse() {
    parse_first_lines();
    for (;;) {
      const std::string word = VtkLegacyScanner::lower(text_.next_word());
      if (word.empty()) scanner_.fail_end();
      if (word == "dataset") {
        parse_dataset();
      } else if (word == "dimensions") {
        std::array<std::uint64_t, 3> sides{};
        for (std::uint64_t& side : sides) side = scanner_.take_count();
        grid_points_ = scanner_.product(scanner_.product(sides[0], sides[1]), sides[2]);
      } else if (word == "field") {
        scanner_.skip_field();
      } else if (word == "metadata") {
        scanner_.skip_metadata();
      } else if (word == "points") {
        return parse_points();
      } else {
        text_.fail("unexpected " + quote_text(word) + " before POINTS; correct the VTK file");
      }
    }
  }

 private:
  void parse_first_lines() {
    constexpr std::string_view kMagic = "# vtk DataFile Version ";
    std::string_view line;
    if (!text_.next_line(line) || !line.starts_with(kMagic)) {
      source_.fail_at(0,
                      "not a legacy VTK file: it does not start with \"# vtk DataFile\"; check "
                      "--input-format");
    }
    const std::string_view version = line.substr(kMagic.size());
    if (version.empty() || version.front() < '1' || version.front() > '5' ||
        (version.size() > 1 && version[1] != '.')) {
      text_.fail("unknown VTK file version " + quote_text(version) + "; known are 1.0 to 5.x");
    }
    if (!text_.next_line(line) || !text_.next_line(line)) scanner_.fail_end();
    const std::string encoding =
        VtkLegacyScanner::lower(line.substr(0, line.find_last_not_of(" \t") + 1));
    if (encoding != "ascii" && encoding != "binary") {
      text_.fail(quote_text(line) + " where ASCII or BINARY should be; correct the VTK file");
    }
    header_.binary = encoding == "binary";
    scanner_.set_binary(header_.binary);
  }

  void parse_dataset() {
    const std::string kind = VtkLegacyScanner::lower(text_.next_word());
    if (kind.empty()) scanner_.fail_end();
    if (kind != "polydata" && kind != "unstructured_grid" && kind != "structured_grid") {
      text_.fail("a dataset " + quote_text(kind) +
                 " has no list of points; give a POLYDATA, "
                 "UNSTRUCTURED_GRID or STRUCTURED_GRID");
    }
    has_dataset_ = true;
    has_grid_ = kind == "structured_grid";
  }

  VtkLegacyHeader parse_points() {
    if (!has_dataset_) text_.fail("POINTS before DATASET; correct the VTK file");
    header_.points = scanner_.take_count();
    const std::string name = VtkLegacyScanner::lower(text_.next_word());
    const std::optional<ScalarType> type = VtkLegacyScanner::type_named(name);
    if (!type || scalar_decoder(*type, std::endian::big) == nullptr) {
      text_.fail("coordinates of type " + quote_text(name) +
                 " are not read exactly; store them as float, double or int");
    }
    header_.type = *type;
    if (has_grid_ && grid_points_ != header_.points) {
      text_.fail("DIMENSIONS and POINTS do not fit; correct the VTK file");
    }
    scanner_.end_line();
    return header_;
  }

  ByteSource& source_;
  TextReader& text_;
  VtkLegacyScanner scanner_;
  VtkLegacyHeader header_;
  bool has_dataset_ = false;
  bool has_grid_ = false;
  std::uint64_t grid_points_ = 0;
};

}  // namespace

VtkLegacyHeader read_vtk_legacy_header(ByteSource& source, TextReader& text) {
  return HeaderParser(source, text).parse();
}

}  // namespace stream_recon
