#include "tools/preview/background.h"

#include <stdexcept>

#include "tools/preview/coloring.h"

namespace stream_recon {

Rgb Background::ink() const {
  if (is_transparent_) return {128, 134, 142};
  if (lightness_of(color_at(0.5F)) > 0.55) return {52, 58, 66};
  return {226, 230, 235};
}

Background parse_background(const std::string& text) {
  if (text == "gradient") return {};
  if (text == "white") return Background::plain({1, 1, 1});
  if (text == "black") return Background::plain({0, 0, 0});
  if (text == "transparent") return Background::transparent();
  if (text.find(',') == std::string::npos) {
    throw std::invalid_argument("the background '" + text +
                                "' is none of gradient, white, black, transparent, and no R,G,B");
  }
  return Background::plain(from_bytes(parse_coloring(text).fixed));
}

}  // namespace stream_recon
