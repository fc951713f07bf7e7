// What the colour of a surface says.
//
// Paints are numbers of a palette's colours, so that a sample of the screen needs two bytes for
// one. Thread rule: values and pure functions.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tools/preview/color.h"

namespace stream_recon {

enum class ColorBy {
  kPiece,      ///< a colour for each input file
  kNone,       ///< one colour for all that has no other
  kFixed,      ///< the colour given
  kDelta,      ///< cell data Delta, degrees
  kSource,     ///< cell data Source
  kClosure,    ///< cell data Closure, spacings
  kComponent,  ///< what hangs together, the largest first
};

struct Coloring {
  ColorBy by = ColorBy::kPiece;
  Rgb fixed{};  ///< for kFixed
};

/// Delta, Source, Closure, component, none, or "R,G,B" (0 to 255 each). \throw
/// std::invalid_argument
Coloring parse_coloring(const std::string& text);

using Paint = std::uint16_t;

/// Where the colours of each kind begin in a palette.
inline constexpr Paint kDistinctPaints = 0;  ///< kDistinctCount, the first is that of kNone
inline constexpr Paint kDistinctCount = 1024;
inline constexpr Paint kDeltaPaints = kDistinctPaints + kDistinctCount;
inline constexpr Paint kDeltaCount = 256;
inline constexpr Paint kFixedPaints = kDeltaPaints + kDeltaCount;  ///< one for each input

/// The number-th of colours that are easy to tell apart; the first is that of a plain surface, and
/// they repeat after kDistinctCount.
Color distinct_color(std::uint64_t number);
Paint distinct_paint(std::uint64_t number);

/// Even in lightness from dark violet (0) to bright yellow (1).
Color scale_color(double value);
/// \param value of the scale, 0 to 1
Paint scale_paint(double value);

/// The palette of all paints. \param fixed colours of the inputs
std::vector<Color> make_palette(const std::vector<Rgb>& fixed);

}  // namespace stream_recon
