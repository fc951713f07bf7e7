// Colours as light: linear red, green and blue, which add up as light does.
//
// A square root makes them the screen's (gamma 2). Thread rule: values.
// Source of the even lightness scale: B. Ottosson, "A perceptual color space for image processing",
// 2020 (OKLab).
#pragma once

#include <array>
#include <cstdint>

namespace stream_recon {

using Rgb = std::array<std::uint8_t, 3>;

struct Color {
  float r = 0;
  float g = 0;
  float b = 0;

  friend Color operator+(const Color& a, const Color& b) {
    return {a.r + b.r, a.g + b.g, a.b + b.b};
  }
  friend Color operator*(const Color& a, const Color& b) {
    return {a.r * b.r, a.g * b.g, a.b * b.b};
  }
  friend Color operator*(float s, const Color& c) { return {s * c.r, s * c.g, s * c.b}; }
};

/// As a screen shows it; values outside 0 to 1 are cut off.
Rgb to_bytes(const Color& color);
Color from_bytes(const Rgb& bytes);

/// A colour by how it looks: equal steps of lightness look equal.
struct Look {
  double lightness = 0;  ///< 0 to 1
  double chroma = 0;     ///< 0 (grey) to about 0.3
  double hue = 0;        ///< degrees: 30 red, 110 yellow, 145 green, 265 blue
};

Color from_look(const Look& look);
/// OKLab's L of a colour.
double lightness_of(const Color& color);

}  // namespace stream_recon
