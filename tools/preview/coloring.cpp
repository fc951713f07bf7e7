#include "tools/preview/coloring.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <stdexcept>

namespace stream_recon {
namespace {

constexpr Color kPlain{0.84F, 0.63F, 0.50F};
constexpr double kGoldenAngle = 137.50776405;  // degrees: no two early multiples are close

Rgb parse_rgb(const std::string& text) {
  std::istringstream stream(text);
  Rgb color{};
  for (int i = 0; i < 3; ++i) {
    int value = -1;
    char comma = ',';
    if (i > 0) stream >> comma;
    stream >> value;
    if (!stream || comma != ',' || value < 0 || value > 255) stream.setstate(std::ios::failbit);
    color[i] = static_cast<std::uint8_t>(value);
  }
  if (!stream || !(stream >> std::ws).eof()) {
    throw std::invalid_argument(
        "the colour '" + text +
        "' is none of Delta, Source, Closure, component, none, and no R,G,B "
        "of numbers from 0 to 255");
  }
  return color;
}

}  // namespace

Coloring parse_coloring(const std::string& text) {
  static const std::map<std::string, ColorBy> names{{"Delta", ColorBy::kDelta},
                                                    {"Source", ColorBy::kSource},
                                                    {"Closure", ColorBy::kClosure},
                                                    {"component", ColorBy::kComponent},
                                                    {"none", ColorBy::kNone}};
  const auto named = names.find(text);
  if (named != names.end()) return {named->second, {}};
  return {ColorBy::kFixed, parse_rgb(text)};
}

Color distinct_color(std::uint64_t number) {
  const std::uint64_t n = number % kDistinctCount;
  if (n == 0) return kPlain;
  constexpr double kLightness[] = {0.72, 0.82, 0.62};
  return from_look(
      {kLightness[n % 3], 0.125, std::fmod(110 + kGoldenAngle * static_cast<double>(n), 360.0)});
}

Paint distinct_paint(std::uint64_t number) {
  return static_cast<Paint>(kDistinctPaints + number % kDistinctCount);
}

Color scale_color(double value) {
  const double t = std::clamp(value, 0.0, 1.0);
  return from_look({0.38 + 0.54 * t, 0.11 + 0.04 * t, 300 - 195 * t});
}

Paint scale_paint(double value) {
  const double t = std::clamp(value, 0.0, 1.0);
  return static_cast<Paint>(kDeltaPaints + std::lround(t * (kDeltaCount - 1)));
}

std::vector<Color> make_palette(const std::vector<Rgb>& fixed) {
  std::vector<Color> palette;
  palette.reserve(kFixedPaints + fixed.size());
  for (Paint i = 0; i < kDistinctCount; ++i) palette.push_back(distinct_color(i));
  for (Paint i = 0; i < kDeltaCount; ++i) {
    palette.push_back(scale_color(static_cast<double>(i) / (kDeltaCount - 1)));
  }
  for (const Rgb& color : fixed) palette.push_back(from_bytes(color));
  return palette;
}

}  // namespace stream_recon
