#include "tools/sampling/slice_alignment.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "io/error.h"

namespace stream_recon {
namespace {

constexpr double kMostVoxels = 1e6;

struct Line {
  double slice = -1;
  SliceOffset offset;
};

bool is_number(const std::string& word, double& value) {
  char* end = nullptr;
  value = std::strtod(word.c_str(), &end);
  return !word.empty() && *end == '\0' && std::isfinite(value);
}

bool parse(const std::string& text, Line& line) {
  std::istringstream words(text);
  std::string slice;
  std::string di;
  std::string dj;
  std::string more;
  words >> slice >> di >> dj;
  return is_number(slice, line.slice) && is_number(di, line.offset.di) &&
         is_number(dj, line.offset.dj) && !(words >> more) &&
         std::abs(line.offset.di) <= kMostVoxels && std::abs(line.offset.dj) <= kMostVoxels;
}

}  // namespace

std::vector<SliceOffset> read_slice_alignment(const std::string& path, std::size_t slices) {
  std::ifstream file(path);
  if (!file) throw IoError(fmt::format("{}: cannot open the offsets; check the name", path));
  std::vector<SliceOffset> offsets(slices);
  std::vector<bool> given(slices);
  std::size_t number = 0;
  for (std::string text; std::getline(file, text);) {
    ++number;
    const auto refuse = [&](const std::string& why) {
      throw InputError(fmt::format("{}: line {}: {}", path, number, why));
    };
    text.erase(std::min(text.find('#'), text.size()));
    std::replace(text.begin(), text.end(), ',', ' ');
    if (text.find_first_not_of(" \t\r") == std::string::npos) continue;
    Line line;
    if (!parse(text, line)) refuse("not \"slice di dj\"; write for example: 12 -1.5 0");
    if (line.slice < 0 || line.slice >= static_cast<double>(slices) ||
        line.slice != std::floor(line.slice)) {
      refuse(fmt::format("no slice {}; they are numbered from 0 to {}", line.slice, slices - 1));
    }
    const auto k = static_cast<std::size_t>(line.slice);
    if (given[k]) refuse(fmt::format("slice {} for the second time; leave one out", k));
    given[k] = true;
    offsets[k] = line.offset;
  }
  if (file.bad()) throw IoError(fmt::format("{}: cannot read on after line {}", path, number));
  return offsets;
}

}  // namespace stream_recon
