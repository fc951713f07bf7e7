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
  expected_end_.reset();
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

void Progress::expect(double seconds) {
  const std::lock_guard lock(mutex_);
  expected_end_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                     std::chrono::duration<double>(seconds));
}

void Progress::end_stage() {
  const std::lock_guard lock(mutex_);
  show(true);
}

void Progress::note(const std::string& text) {
  const std::lock_guard lock(mutex_);
  if (style_ == ProgressStyle::kBar) fmt::print(out_, "\r\033[K{}\n", text);
  if (style_ == ProgressStyle::kJson) {
    fmt::print(out_, "{}\n", nlohmann::ordered_json{{"note", text}}.dump());
  }
  std::fflush(out_);
}

void Progress::show(bool last) {
  const double seconds = std::chrono::duration<double>(Clock::now() - began_).count();
  if (style_ == ProgressStyle::kBar) show_bar(seconds, last);
  if (style_ == ProgressStyle::kJson) show_json(seconds);
}

std::optional<double> Progress::seconds_left(double seconds) const {
  if (expected_end_) {
    return std::max(0.0, std::chrono::duration<double>(*expected_end_ - Clock::now()).count());
  }
  const std::uint64_t done = done_;
  if (total_ == 0 || done == 0) return std::nullopt;
  const std::uint64_t left = total_ > done ? total_ - done : 0;
  return static_cast<double>(left) * seconds / static_cast<double>(done);
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
  const auto left = seconds_left(seconds);
  if (!last && left) line += fmt::format(", {} left", duration_text(*left));
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
    if (const auto left = seconds_left(seconds)) line["seconds_left"] = *left;
  }
  fmt::print(out_, "{}\n", line.dump());
  std::fflush(out_);
}

}  // namespace stream_recon
