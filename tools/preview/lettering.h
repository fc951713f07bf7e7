// Plain text in a picture, drawn with strokes so that no font is needed.
//
// Letters, digits and the usual signs of ASCII; what is unknown shows as a question mark.
// Guarantees: the same pixels everywhere. Thread rule: stateless. Cost: a distance to each stroke
// of a letter for each of its pixels.
#pragma once

#include <string_view>

#include "tools/preview/picture.h"

namespace stream_recon {

struct Lettering {
  double x = 0;         ///< left edge of the text, pixels
  double baseline = 0;  ///< row the letters stand on
  double size = 12;     ///< from a line of text to the next, pixels
  Rgb ink{};
};

void write_text(Picture& picture, std::string_view text, const Lettering& style);

/// Pixels that a text of that size is wide.
double text_width(std::string_view text, double size);

}  // namespace stream_recon
