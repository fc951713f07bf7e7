// What the colours of a picture mean, in a column at its right edge.
//
// Thread rule: values and pure functions.
#pragma once

#include <string>
#include <vector>

#include "tools/preview/background.h"
#include "tools/preview/picture.h"

namespace stream_recon {

struct LegendEntry {
  Color color;
  std::string label;
};

struct LegendBlock {
  std::string title;
  std::vector<LegendEntry> entries;
  double scale_end = 0;  ///< above 0: a bar of scale_color() from 0 to here instead of entries
};

struct LegendStyle {
  double text_size = 12;  ///< from a line to the next, pixels
  Background background;
};

/// Pixels.
std::size_t legend_width(const std::vector<LegendBlock>& blocks, double text_size);

/// The column, `height` pixels high.
Picture draw_legend(const std::vector<LegendBlock>& blocks, std::size_t height,
                    const LegendStyle& style);

}  // namespace stream_recon
