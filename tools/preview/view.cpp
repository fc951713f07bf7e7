#include "tools/preview/view.h"

#include <cmath>
#include <map>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace stream_recon {
namespace {

using Angles = std::pair<double, double>;

double dot(const Point3& a, const Point3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

Angles parse_angles(const std::string& text) {
  std::istringstream stream(text);
  Angles angles;
  char comma = 0;
  stream >> angles.first >> comma >> angles.second;
  const bool read = stream && comma == ',' && (stream >> std::ws).eof();
  if (!read || std::abs(angles.first) > 360 || std::abs(angles.second) > 90) {
    throw std::invalid_argument(
        "the view '" + text +
        "' is none of front, back, left, right, top, bottom, and no AZIMUTH,ELEVATION in degrees");
  }
  return angles;
}

}  // namespace

Point3 View::operator()(const Point3& p) const {
  return {dot(right, p), dot(up, p), dot(toward, p)};
}

View parse_view(const std::string& text) {
  static const std::map<std::string, Angles> named_views{{"front", {0, 0}}, {"back", {180, 0}},
                                                         {"left", {90, 0}}, {"right", {-90, 0}},
                                                         {"top", {0, 90}},  {"bottom", {0, -90}}};
  const auto named = named_views.find(text);
  const Angles angles = named != named_views.end() ? named->second : parse_angles(text);
  constexpr double kRadian = std::numbers::pi / 180;
  const double ca = std::cos(angles.first * kRadian);
  const double sa = std::sin(angles.first * kRadian);
  const double ce = std::cos(angles.second * kRadian);
  const double se = std::sin(angles.second * kRadian);
  return {{ca, sa, 0}, {-sa * se, ca * se, ce}, {sa * ce, -ca * ce, se}};
}

std::vector<NamedView> parse_views(const std::string& text) {
  std::vector<std::string> words(1);
  for (const char c : text) {
    if (c == ',') {
      words.emplace_back();
    } else {
      words.back() += c;
    }
  }
  const auto is_word = [](const std::string& word) {
    return !word.empty() && word[0] >= 'a' && word[0] <= 'z';
  };
  std::vector<NamedView> views;
  for (std::size_t i = 0; i < words.size(); ++i) {
    std::string name = words[i];
    if (!is_word(name) && i + 1 < words.size()) name += "," + words[++i];
    views.push_back({name, parse_view(name)});
  }
  return views;
}

}  // namespace stream_recon
