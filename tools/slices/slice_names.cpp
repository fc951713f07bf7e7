#include "tools/slices/slice_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <limits>
#include <string_view>

#include "io/error.h"

namespace stream_recon {
namespace {

bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/// Alternately text and numbers, beginning with text.
std::vector<std::string> parts_of(std::string_view name) {
  std::vector<std::string> parts(1);
  for (const char c : name) {
    if (is_digit(c) == (parts.size() % 2 == 1)) parts.emplace_back();
    parts.back() += c;
  }
  return parts;
}

std::string_view without_zeros(std::string_view number) {
  const std::size_t first = std::min(number.find_first_not_of('0'), number.size() - 1);
  return number.substr(first);
}

bool is_before(const std::string& a, const std::string& b) {
  const auto left = parts_of(a);
  const auto right = parts_of(b);
  for (std::size_t n = 0; n < std::min(left.size(), right.size()); ++n) {
    if (n % 2 == 0) {
      if (left[n] != right[n]) return left[n] < right[n];
      continue;
    }
    const std::string_view x = without_zeros(left[n]);
    const std::string_view y = without_zeros(right[n]);
    if (x.size() != y.size()) return x.size() < y.size();
    if (x != y) return x < y;
  }
  return left.size() != right.size() ? left.size() < right.size() : a < b;
}

/// The numbers of names that differ in one of them only; nothing if they do not.
struct NumberedRow {
  std::vector<std::int64_t> numbers;
  std::size_t part = 0;
};

NumberedRow numbered_row(const std::vector<std::string>& names) {
  NumberedRow row;
  const auto first = parts_of(names.front());
  for (const std::string& name : names) {
    const auto parts = parts_of(name);
    if (parts.size() != first.size()) return {};
    for (std::size_t n = 0; n < parts.size(); ++n) {
      if (parts[n] == first[n] || n == row.part) continue;
      if (n % 2 == 0 || row.part != 0) return {};
      row.part = n;
    }
  }
  if (row.part == 0) return {};
  for (const std::string& name : names) {
    const auto digits = parts_of(name)[row.part];
    if (without_zeros(digits).size() > 18) return {};
    row.numbers.push_back(std::stoll(digits));
  }
  return row;
}

/// A name of the row with another number in it.
std::string renumbered(const std::string& name, std::size_t part, std::int64_t number) {
  auto parts = parts_of(name);
  const std::size_t width = parts[part].starts_with('0') ? parts[part].size() : 0;
  parts[part] = fmt::format("{:0{}}", number, width);
  return fmt::format("{}", fmt::join(parts, ""));
}

constexpr std::size_t kLeastForSteps = 4;  // fewer in steps are rather a row with gaps

}  // namespace

void sort_naturally(std::vector<std::string>& names) {
  std::sort(names.begin(), names.end(), is_before);
}

std::string shape_of_name(const std::string& name) {
  auto parts = parts_of(name);
  for (std::size_t n = 1; n < parts.size(); n += 2) parts[n].assign(1, '#');
  return fmt::format("{}", fmt::join(parts, ""));
}

void check_numbered_row(const std::string& folder, const std::vector<std::string>& names) {
  if (names.size() < 2) return;
  const NumberedRow row = numbered_row(names);
  std::int64_t step = std::numeric_limits<std::int64_t>::max();
  for (std::size_t n = 1; n < row.numbers.size(); ++n) {
    const std::int64_t gap = row.numbers[n] - row.numbers[n - 1];
    step = std::min(step, gap);
    if (gap != 0) continue;
    throw InputError(fmt::format("{}: {} and {} have the same number; remove one of them", folder,
                                 names[n - 1], names[n]));
  }
  if (names.size() < kLeastForSteps) step = 1;
  for (std::size_t n = 1; n < row.numbers.size(); ++n) {
    if (row.numbers[n] - row.numbers[n - 1] == step) continue;
    throw InputError(fmt::format(
        "{}: {} is missing between {} and {}; add it, or rename the rest", folder,
        renumbered(names[n - 1], row.part, row.numbers[n - 1] + step), names[n - 1], names[n]));
  }
}

}  // namespace stream_recon
