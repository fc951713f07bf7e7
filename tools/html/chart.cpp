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

std::string count_text(double value) {
  if (value >= 1e7) return fmt::format("{:g} M", value / 1e6);
  return count(static_cast<std::uint64_t>(value));
}

/// Ticks are whole in the unit of the largest.
std::string memory_text(double value, double step) {
  if (value == 0) return "0";
  constexpr double kKibi = 1024;
  if (step >= kKibi * kKibi * kKibi) return fmt::format("{:g} GiB", value / kKibi / kKibi / kKibi);
  return fmt::format("{:g} MiB", value / kKibi / kKibi);
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
  const double step = binary_step(top);
  Plot plot({.x_end = end,
             .y_end = top,
             .x_text = [](double s) { return s == 0 ? "0" : fmt::format("{:g} s", s); },
             .y_text = [step](double value) { return memory_text(value, step); },
             .y_step = step,
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
  if (is_near) {
    plot.level(budget, "budget " + bytes(report.memory_budget_bytes));
    return plot.svg();
  }
  return plot.svg() + fmt::format("<p class=\"hint\">The budget, {}, lies far above.</p>\n",
                                  bytes(report.memory_budget_bytes));
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
             .y_text = count_text,
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
