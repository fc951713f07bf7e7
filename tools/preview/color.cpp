#include "tools/preview/color.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stream_recon {
namespace {

std::uint8_t to_byte(float linear) {
  return static_cast<std::uint8_t>(std::lround(255 * std::sqrt(std::clamp(linear, 0.0F, 1.0F))));
}

float from_byte(std::uint8_t byte) {
  const float screen = static_cast<float>(byte) / 255;
  return screen * screen;
}

float cut(double value) {
  return static_cast<float>(std::clamp(value, 0.0, 1.0));
}

}  // namespace

Rgb to_bytes(const Color& color) {
  return {to_byte(color.r), to_byte(color.g), to_byte(color.b)};
}

Color from_bytes(const Rgb& bytes) {
  return {from_byte(bytes[0]), from_byte(bytes[1]), from_byte(bytes[2])};
}

Color from_look(const Look& look) {
  const double angle = look.hue * std::numbers::pi / 180;
  const double a = look.chroma * std::cos(angle);
  const double b = look.chroma * std::sin(angle);
  const auto cube = [](double x) { return x * x * x; };
  const double l = cube(look.lightness + 0.3963377774 * a + 0.2158037573 * b);
  const double m = cube(look.lightness - 0.1055613458 * a - 0.0638541728 * b);
  const double s = cube(look.lightness - 0.0894841775 * a - 1.2914855480 * b);
  return {cut(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
          cut(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
          cut(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

double lightness_of(const Color& c) {
  const double l = std::cbrt(0.4122214708 * c.r + 0.5363325363 * c.g + 0.0514459929 * c.b);
  const double m = std::cbrt(0.2119034982 * c.r + 0.6806995451 * c.g + 0.1073969566 * c.b);
  const double s = std::cbrt(0.0883024619 * c.r + 0.2817188376 * c.g + 0.6299787005 * c.b);
  return 0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s;
}

}  // namespace stream_recon
