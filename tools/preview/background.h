// What is behind the mesh.
//
// Thread rule: a value.
#pragma once

#include <string>

#include "tools/preview/color.h"

namespace stream_recon {

class Background {
 public:
  /// A light neutral gradient.
  Background() = default;
  static Background plain(const Color& color) { return Background(color, color, false); }
  static Background transparent() { return Background({}, {}, true); }

  /// \param height 0 at the bottom, 1 at the top
  Color color_at(float height) const { return height * top_ + (1 - height) * bottom_; }
  bool is_transparent() const { return is_transparent_; }
  /// What can be read on it; on a transparent one grey, for light and dark pages.
  Rgb ink() const;

 private:
  Background(const Color& top, const Color& bottom, bool is_transparent)
      : top_(top), bottom_(bottom), is_transparent_(is_transparent) {}

  Color top_{0.93F, 0.94F, 0.96F};
  Color bottom_{0.66F, 0.69F, 0.74F};
  bool is_transparent_ = false;
};

/// gradient, white, black, transparent, or "R,G,B". \throw std::invalid_argument
Background parse_background(const std::string& text);

}  // namespace stream_recon
