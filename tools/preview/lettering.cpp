#include "tools/preview/lettering.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace stream_recon {
namespace {

// A glyph is strokes, divided by commas, each a list of points x y on a grid: letters stand on row
// 2, small ones reach 6, capitals 8, tails 0.
struct Glyph {
  char letter;
  const char* strokes;
};

constexpr Glyph kGlyphs[] = {
    {'0', "18 28 37 33 22 12 03 07 18"},
    {'1', "07 18 12,02 22"},
    {'2', "07 18 28 37 36 02 32"},
    {'3', "07 18 28 37 36 25 15,25 34 33 22 12 03"},
    {'4', "22 28 04 34"},
    {'5', "38 08 05 25 34 33 22 12 03"},
    {'6', "37 28 18 07 03 12 22 33 34 25 15 04"},
    {'7', "08 38 12"},
    {'8', "15 06 07 18 28 37 36 25 15 04 03 12 22 33 34 25"},
    {'9', "03 12 22 33 37 28 18 07 06 15 25 36"},
    {'A', "02 28 42,14 34"},
    {'B', "02 08 38 47 46 35 05,35 44 43 32 02"},
    {'C', "47 38 18 07 03 12 32 43"},
    {'D', "02 08 28 46 44 22 02"},
    {'E', "42 02 08 48,05 35"},
    {'F', "02 08 48,05 35"},
    {'G', "47 38 18 07 03 12 32 43 45 25"},
    {'H', "02 08,42 48,05 45"},
    {'I', "02 08"},
    {'J', "38 33 22 12 03"},
    {'K', "02 08,48 05 42"},
    {'L', "08 02 32"},
    {'M', "02 08 25 48 42"},
    {'N', "02 08 42 48"},
    {'O', "18 38 47 43 32 12 03 07 18"},
    {'P', "02 08 38 47 46 35 05"},
    {'Q', "18 38 47 43 32 12 03 07 18,24 42"},
    {'R', "02 08 38 47 46 35 05,25 42"},
    {'S', "47 38 18 07 06 15 35 44 43 32 12 03"},
    {'T', "08 48,28 22"},
    {'U', "08 03 12 32 43 48"},
    {'V', "08 22 48"},
    {'W', "08 12 36 52 68"},
    {'X', "08 42,48 02"},
    {'Y', "08 25 48,25 22"},
    {'Z', "08 48 02 42"},
    {'a', "05 16 26 35 32,34 14 03 12 22 33"},
    {'b', "08 02,05 16 26 35 33 22 12 03"},
    {'c', "35 26 16 05 03 12 22 33"},
    {'d', "38 32,35 26 16 05 03 12 22 33"},
    {'e', "04 34 35 26 16 05 03 12 22 33"},
    {'f', "28 17 12,06 26"},
    {'g', "36 31 20 10 01,35 26 16 05 03 12 22 33"},
    {'h', "08 02,05 16 26 35 32"},
    {'i', "06 02,08 08"},
    {'j', "16 11 00,18 18"},
    {'k', "08 02,36 04 32"},
    {'l', "08 03 12"},
    {'m', "06 02,05 16 25 22,25 36 45 42"},
    {'n', "06 02,05 16 26 35 32"},
    {'o', "16 26 35 33 22 12 03 05 16"},
    {'p', "06 00,05 16 26 35 33 22 12 03"},
    {'q', "36 30,35 26 16 05 03 12 22 33"},
    {'r', "06 02,04 16 26"},
    {'s', "35 26 16 05 14 24 33 22 12 03"},
    {'t', "18 13 22,06 26"},
    {'u', "06 03 12 22 33,36 32"},
    {'v', "06 22 46"},
    {'w', "06 12 25 32 46"},
    {'x', "06 32,36 02"},
    {'y', "06 22,46 10"},
    {'z', "06 36 02 32"},
    {'.', "02 02"},
    {',', "12 01"},
    {'-', "04 24"},
    {'_', "01 41"},
    {'/', "01 39"},
    {':', "05 05,02 02"},
    {'(', "19 07 03 11"},
    {')', "09 17 13 01"},
    {'+', "04 44,26 22"},
    {'=', "05 35,03 33"},
    {'%', "02 48,07 07,43 43"},
    {'?', "07 18 28 37 36 15 14,12 12"},
};

constexpr double kRows = 12;  // of the grid from a line of text to the next
constexpr double kBaseline = 2;
constexpr double kGap = 1.9;    // between letters
constexpr double kSpace = 1.2;  // a blank, beside the gap
constexpr double kHalfStroke = 0.46;

struct Segment {
  double x0, y0, x1, y1;
};

struct Outline {
  std::vector<Segment> segments;
  double width = 0;
};

Outline outline_of(char letter) {
  const auto* found = std::find_if(std::begin(kGlyphs), std::end(kGlyphs),
                                   [letter](const Glyph& g) { return g.letter == letter; });
  if (found == std::end(kGlyphs)) found = std::end(kGlyphs) - 1;
  Outline outline;
  bool is_first = true;
  double last_x = 0;
  double last_y = 0;
  for (const char* at = found->strokes; *at != 0;) {
    if (*at == ',' || *at == ' ') {
      is_first |= *at == ',';
      ++at;
      continue;
    }
    const double x = at[0] - '0';
    const double y = at[1] - '0';
    outline.segments.push_back({is_first ? x : last_x, is_first ? y : last_y, x, y});
    outline.width = std::max(outline.width, x);
    last_x = x;
    last_y = y;
    is_first = false;
    at += 2;
  }
  return outline;
}

double distance(const Segment& s, double x, double y) {
  const double dx = s.x1 - s.x0;
  const double dy = s.y1 - s.y0;
  const double square = dx * dx + dy * dy;
  const double t =
      square > 0 ? std::clamp(((x - s.x0) * dx + (y - s.y0) * dy) / square, 0.0, 1.0) : 0;
  return std::hypot(x - s.x0 - t * dx, y - s.y0 - t * dy);
}

/// Draws one letter with its left edge at `left`.
void draw(Picture& picture, const Outline& outline, double left, const Lettering& style) {
  const double unit = style.size / kRows;
  const auto begin_x = static_cast<std::ptrdiff_t>(std::floor(left - unit));
  const auto end_x = static_cast<std::ptrdiff_t>(std::ceil(left + (outline.width + 1) * unit)) + 1;
  const auto begin_y = static_cast<std::ptrdiff_t>(std::floor(style.baseline - 8 * unit));
  const auto end_y = static_cast<std::ptrdiff_t>(std::ceil(style.baseline + 3 * unit)) + 1;
  for (std::ptrdiff_t y = begin_y; y < end_y; ++y) {
    for (std::ptrdiff_t x = begin_x; x < end_x; ++x) {
      const double gx = (static_cast<double>(x) + 0.5 - left) / unit;
      const double gy = kBaseline + (style.baseline - static_cast<double>(y) - 0.5) / unit;
      double nearest = 100;
      for (const Segment& segment : outline.segments) {
        nearest = std::min(nearest, distance(segment, gx, gy));
      }
      const double coverage = std::clamp((kHalfStroke - nearest) * unit + 0.5, 0.0, 1.0);
      picture.blend(x, y, style.ink, static_cast<float>(coverage));
    }
  }
}

}  // namespace

void write_text(Picture& picture, std::string_view text, const Lettering& style) {
  const double unit = style.size / kRows;
  double x = style.x;
  for (const char letter : text) {
    if (letter == ' ') {
      x += (kSpace + kGap) * unit;
      continue;
    }
    const Outline outline = outline_of(letter);
    draw(picture, outline, x, style);
    x += (outline.width + kGap) * unit;
  }
}

double text_width(std::string_view text, double size) {
  double units = 0;
  for (const char letter : text)
    units += kGap + (letter == ' ' ? kSpace : outline_of(letter).width);
  return units * size / kRows;
}

}  // namespace stream_recon
