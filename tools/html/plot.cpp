#include "tools/html/plot.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "tools/html/text.h"

namespace stream_recon::html {
namespace {

// In units of the drawing, which are about pixels.
constexpr double kWidth = 560;
constexpr double kHeight = 260;
constexpr double kLeft = 62;
constexpr double kRight = 12;
constexpr double kTop = 24;
constexpr double kBottom = 30;
constexpr double kLetter = 6.2;  // about the width of a letter of a label

}  // namespace

double round_step(double end, int ticks) {
  if (!(end > 0)) return 1;
  const double rough = end / ticks;
  const double power = std::pow(10, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= rough * 0.999) return factor * power;
  }
  return 10 * power;
}

Plot::Plot(PlotAxes axes) : axes_(std::move(axes)) {
  if (!(axes_.x_end > 0)) axes_.x_end = 1;
  if (!(axes_.y_end > 0)) axes_.y_end = 1;
  if (axes_.x_step == 0) axes_.x_step = round_step(axes_.x_end, 6);
  if (axes_.y_step == 0) axes_.y_step = round_step(axes_.y_end, 4);
}

double Plot::px(double x) const {
  return kLeft + (kWidth - kLeft - kRight) * x / axes_.x_end;
}

double Plot::py(double y) const {
  return kHeight - kBottom - (kHeight - kTop - kBottom) * y / axes_.y_end;
}

void Plot::box(double x0, double y0, double x1, double y1, std::string_view attributes) {
  marks_ += fmt::format(R"(<rect x="{:.2f}" y="{:.2f}" width="{:.2f}" height="{:.2f}" {}/>)",
                        px(x0), py(y1), px(x1) - px(x0), py(y0) - py(y1), attributes);
}

void Plot::add_point(double x, double y) {
  if (path_.empty()) first_x_ = x;
  last_x_ = x;
  path_ += fmt::format("{}{:.2f} {:.2f}", path_.empty() ? "M" : "L", px(x), py(y));
}

void Plot::end_area() {
  if (path_.empty()) return;
  marks_ += fmt::format(R"(<path class="area" d="{}L{:.2f} {:.2f}L{:.2f} {:.2f}Z"/>)", path_,
                        px(last_x_), py(0), px(first_x_), py(0));
  marks_ += fmt::format(R"(<path class="line" d="{}"/>)", path_);
  path_.clear();
}

void Plot::level(double y, const std::string& label) {
  over_ += fmt::format(R"(<path class="level" d="M{:.2f} {:.2f}H{:.2f}"/>)", px(0), py(y),
                       px(axes_.x_end));
  over_ +=
      fmt::format(R"(<text class="level-text" x="{:.2f}" y="{:.2f}" text-anchor="end">{}</text>)",
                  px(axes_.x_end) - 4, py(y) - 5, escape(label));
}

void Plot::heading(double x0, double x1, const std::string& text) {
  if (px(x1) - px(x0) < kLetter * static_cast<double>(text.size()) + 6) return;
  over_ += fmt::format(R"(<text x="{:.2f}" y="{:.2f}" text-anchor="middle">{}</text>)",
                       (px(x0) + px(x1)) / 2, kTop - 8, escape(text));
}

std::string Plot::frame() const {
  std::string text;
  for (int i = 0; i * axes_.y_step <= axes_.y_end * 1.0001; ++i) {
    const double value = i * axes_.y_step;
    text += fmt::format(R"(<path class="{}" d="M{:.2f} {:.2f}H{:.2f}"/>)", i == 0 ? "axis" : "grid",
                        px(0), py(value), px(axes_.x_end));
    text += fmt::format(R"(<text x="{:.2f}" y="{:.2f}" text-anchor="end">{}</text>)", px(0) - 8,
                        py(value) + 4, escape(axes_.y_text(value)));
  }
  for (int i = 0; i * axes_.x_step <= axes_.x_end * 1.0001; ++i) {
    const double value = i * axes_.x_step;
    const bool is_last = px(value) > kWidth - kRight - 12;
    text += fmt::format(R"(<text x="{:.2f}" y="{:.2f}" text-anchor="{}">{}</text>)",
                        is_last ? kWidth - kRight : px(value), py(0) + 19,
                        is_last ? "end" : "middle", escape(axes_.x_text(value)));
  }
  return text;
}

std::string Plot::svg() const {
  return fmt::format(R"(<svg viewBox="0 0 {} {}" role="img" aria-label="{}">{}{}{}</svg>)", kWidth,
                     kHeight, escape(axes_.title), marks_, frame(), over_);
}

}  // namespace stream_recon::html
