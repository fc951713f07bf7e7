#include "tools/html/chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tools/html/plot.h"
#include "tools/html/text.h"
#include "tools/preview/coloring.h"

namespace stream_recon::html {
namespace {

constexpr double kNear = 4;  // a budget beyond so many peaks would flatten the curve

/// 1, 2, 4, ... of a power of 1024, so that ticks are round in their unit.
double binary_step(double end) {
  double step = 1;
  while (step * 5 < end) step *= 2;
  return step;
}

std::string hex(const Rgb& color) {
  return fmt::format("#{:02x}{:02x}{:02x}", color[0], color[1], color[2]);
}

std::string short_count(double value) {
  if (value >= 1e6) return fmt::format("{:g} M", value / 1e6);
  if (value >= 1e4) return fmt::format("{:g} k", value / 1e3);
  return fmt::format("{:g}", value);
}

}  // namespace

std::string memory_chart(const Report& report) {
  const auto budget = static_cast<double>(report.memory_budget_bytes);
  double peak = static_cast<double>(report.peak_rss_bytes);
  double end = report.seconds;
  for (const MemorySample& sample : report.memory_over_time) {
    peak = std::max(peak, static_cast<double>(sample.resident_bytes));
    end = std::max(end, sample.seconds);
  }
  const bool is_near = budget > 0 && budget < kNear * peak;
  const double top = 1.1 * (is_near ? std::max(budget, peak) : peak);
  Plot plot({.x_end = end,
             .y_end = top,
             .x_text = [](double s) { return s == 0 ? "0" : fmt::format("{:g} s", s); },
             .y_text = [](double b) { return bytes(static_cast<std::uint64_t>(b)); },
             .y_step = binary_step(top),
             .title = "Resident memory over time"});
  bool is_odd = false;
  for (const StageReport& stage : report.stages) {
    const double stage_end = stage.start_seconds + stage.seconds;
    if (is_odd) plot.box(stage.start_seconds, 0, std::min(stage_end, end), top, R"(class="band")");
    plot.heading(stage.start_seconds, stage_end, stage.name);
    is_odd = !is_odd;
  }
  for (const MemorySample& sample : report.memory_over_time) {
    plot.add_point(sample.seconds, static_cast<double>(sample.resident_bytes));
  }
  plot.end_area();
  if (is_near) plot.level(budget, "budget " + bytes(report.memory_budget_bytes));
  return plot.svg();
}

std::string delta_chart(const DeltaHistogram& histogram) {
  std::size_t degrees = histogram.size();
  while (degrees > 1 && histogram[degrees - 1] == 0) --degrees;
  degrees = degrees <= 90 ? 90 : 180;
  const auto most = static_cast<double>(*std::max_element(histogram.begin(), histogram.end()));
  const double top = std::max(1.0, 1.05 * most);
  Plot plot({.x_end = static_cast<double>(degrees),
             .y_end = top,
             .x_text = [](double d) { return fmt::format("{:g}°", d); },
             .y_text = short_count,
             .x_step = degrees / 6.0,
             .y_step = std::max(1.0, round_step(top, 4)),
             .title = "Number of triangles by angle Delta"});
  for (std::size_t i = 0; i < degrees; ++i) {
    if (histogram[i] == 0) continue;
    const auto at = static_cast<double>(i);
    const double value = (at + 0.5) / static_cast<double>(degrees);
    plot.box(at + 0.06, 0, at + 0.94, static_cast<double>(histogram[i]),
             fmt::format(R"(fill="{}")", hex(to_bytes(scale_color(value)))));
  }
  return plot.svg();
}

}  // namespace stream_recon::html
