#include "tools/preview/legend.h"

#include <algorithm>
#include <cmath>

#include "tools/preview/coloring.h"
#include "tools/preview/lettering.h"

namespace stream_recon {
namespace {

// In lines of text.
constexpr double kMargin = 1.2;
constexpr double kSwatch = 0.8;
constexpr double kIndent = 1.5;    // of a label behind its swatch
constexpr double kLine = 1.5;      // from an entry to the next
constexpr double kBarLength = 14;  // at most
constexpr int kTicks = 6;

class Column {
 public:
  Column(Picture& picture, const LegendStyle& style)
      : picture_(picture),
        size_(style.text_size),
        ink_(style.background.ink()),
        y_(kMargin * size_) {}

  void draw(const LegendBlock& block) {
    text(block.title, 0, y_);
    y_ += kLine * size_;
    if (block.scale_end > 0) draw_scale(block.scale_end);
    for (const LegendEntry& entry : block.entries) {
      fill({0, y_, kSwatch * size_, y_ + kSwatch * size_}, entry.color);
      text(entry.label, kIndent * size_, y_);
      y_ += kLine * size_;
    }
    y_ += size_;
  }

 private:
  struct Area {
    double left, top, right, bottom;
  };

  void draw_scale(double end) {
    const double height = static_cast<double>(picture_.height());
    const double length = std::min(kBarLength * size_, std::max(0.0, height - y_ - 2 * size_));
    for (int row = 0; row < static_cast<int>(length); ++row) {
      const double top = y_ + row;
      fill({0, top, kSwatch * size_, top + 1}, scale_color(1 - (row + 0.5) / length));
    }
    const int ticks = length > kTicks * kLine * size_ ? kTicks : kTicks / 3;
    for (int tick = 0; tick <= ticks; ++tick) {
      const double value = end * tick / ticks;
      const double y = y_ + length * (ticks - tick) / ticks - kSwatch * size_ / 2;
      text(std::to_string(std::lround(value)), kIndent * size_, y);
    }
    y_ += length + size_;
  }

  void fill(const Area& area, const Color& color) {
    for (auto y = std::lround(area.top); y < std::lround(area.bottom); ++y) {
      for (auto x = std::lround(area.left); x < std::lround(area.right); ++x) {
        picture_.blend(x, y, to_bytes(color), 1);
      }
    }
  }

  /// \param top of a swatch beside it
  void text(const std::string& text, double left, double top) {
    write_text(picture_, text,
               {.x = left, .baseline = top + 0.65 * size_, .size = size_, .ink = ink_});
  }

  Picture& picture_;
  double size_;
  Rgb ink_;
  double y_;
};

}  // namespace

std::size_t legend_width(const std::vector<LegendBlock>& blocks, double size) {
  if (blocks.empty()) return 0;
  double widest = 0;
  for (const LegendBlock& block : blocks) {
    widest = std::max(widest, text_width(block.title, size));
    for (const LegendEntry& entry : block.entries) {
      widest = std::max(widest, kIndent * size + text_width(entry.label, size));
    }
  }
  return static_cast<std::size_t>(std::ceil(widest + kMargin * size));
}

Picture draw_legend(const std::vector<LegendBlock>& blocks, std::size_t height,
                    const LegendStyle& style) {
  Picture picture(legend_width(blocks, style.text_size), height);
  for (std::size_t y = 0; y < height; ++y) {
    const float up = 1 - (static_cast<float>(y) + 0.5F) / static_cast<float>(height);
    for (std::size_t x = 0; x < picture.width(); ++x) {
      picture.at(x, y) = to_bytes(style.background.color_at(up));
      if (style.background.is_transparent()) picture.opacity(x, y) = 0;
    }
  }
  Column column(picture, style);
  for (const LegendBlock& block : blocks) column.draw(block);
  return picture;
}

}  // namespace stream_recon
