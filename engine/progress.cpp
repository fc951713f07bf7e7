#include "engine/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace stream_recon {
namespace {

constexpr auto kInterval = std::chrono::milliseconds(200);
constexpr int kBarCells = 24;

ProgressStyle resolve(ProgressStyle style, std::FILE* out) {
  if (style != ProgressStyle::kAuto) return style;
  return isatty(fileno(out)) == 1 ? ProgressStyle::kBar : ProgressStyle::kNone;
}

std::string count_text(double count) {
  if (count >= 1e9) return fmt::format("{:.2f} G", count / 1e9);
  if (count >= 1e6) return fmt::format("{:.2f} M", count / 1e6);
  if (count >= 1e4) return fmt::format("{:.0f} k", count / 1e3);
  return fmt::format("{:.0f} ", count);
}

std::string duration_text(double seconds) {
  const auto whole = std::llround(seconds);
  if (whole >= 3600)
    return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
  return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

}  // namespace

Progress::Progress(ProgressStyle style, std::FILE* out) : style_(resolve(style, out)), out_(out) {}

Progress::~Progress() {
  if (line_open_) std::fputc('\n', out_);
}

void Progress::begin_stage(std::string name, std::uint64_t total, std::string unit) {
  const std::lock_guard lock(mutex_);
  name_ = std::move(name);
  unit_ = std::move(unit);
  total_ = total;
  done_ = 0;
  began_ = Clock::now();
  next_ = (began_ + kInterval).time_since_epoch().count();
  show(false);
}

void Progress::advance(std::uint64_t units) {
  if (style_ == ProgressStyle::kNone) return;
  done_.fetch_add(units, std::memory_order_relaxed);
  const auto now = Clock::now().time_since_epoch().count();
  if (now < next_.load(std::memory_order_relaxed)) return;
  const std::unique_lock lock(mutex_, std::try_to_lock);
  if (!lock || now < next_) return;
  next_ = now + Clock::duration(kInterval).count();
  show(false);
}

void Progress::end_stage() {
  const std::lock_guard lock(mutex_);
  show(true);
}

void Progress::show(bool last) {
  const double seconds = std::chrono::duration<double>(Clock::now() - began_).count();
  if (style_ == ProgressStyle::kBar) show_bar(seconds, last);
  if (style_ == ProgressStyle::kJson) show_json(seconds);
}

void Progress::show_bar(double seconds, bool last) {
  const double done = static_cast<double>(done_.load());
  const double rate = seconds > 0 ? done / seconds : 0;
  std::string line = fmt::format("\r\033[K{:<10} ", name_);
  if (total_ > 0) {
    const double part = std::min(1.0, done / static_cast<double>(total_));
    const int full = static_cast<int>(part * kBarCells);
    line += fmt::format("[{:#<{}}{:.<{}}] {:3.0f} %  ", "", full, "", kBarCells - full, part * 100);
  }
  line += fmt::format("{}{}", count_text(done), unit_);
  if (rate > 0) line += fmt::format(", {}{}/s", count_text(rate), unit_);
  line += fmt::format(", {}", duration_text(seconds));
  if (!last && rate > 0 && total_ > 0) {
    const double left = std::max(0.0, static_cast<double>(total_) - done) / rate;
    line += fmt::format(", {} left", duration_text(left));
  }
  if (last) line += '\n';
  line_open_ = !last;
  std::fputs(line.c_str(), out_);
  std::fflush(out_);
}

void Progress::show_json(double seconds) {
  const std::uint64_t done = done_;
  const double rate = seconds > 0 ? static_cast<double>(done) / seconds : 0;
  nlohmann::ordered_json line{
      {"stage", name_}, {"done", done}, {"unit", unit_}, {"seconds", seconds}, {"rate", rate}};
  if (total_ > 0) {
    line["total"] = total_;
    if (rate > 0) {
      const std::uint64_t left = total_ > done ? total_ - done : 0;
      line["seconds_left"] = static_cast<double>(left) / rate;
    }
  }
  fmt::print(out_, "{}\n", line.dump());
  std::fflush(out_);
}

}  // namespace stream_recon
