// Numbers written as text, and text quoted in messages.
//
// Guarantees: the nearest value of the asked type (round to even), independent of the locale;
// "nan" and "inf" in any case are numbers, an overflow is infinite, an underflow zero or denormal.
// Thread rule: stateless. Cost: about 20 ns a number.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace stream_recon {

/// Reads a number at the front of [begin, end); the first character behind it, or nullptr where
/// no number starts. A leading '+' is allowed.
const char* parse_double(const char* begin, const char* end, double& value);

/// The same, rounded to float and widened: for text in a column that is declared as float.
const char* parse_float(const char* begin, const char* end, double& value);

/// The whole of `text` as a number; nothing if it is none.
std::optional<double> whole_double(std::string_view text);
std::optional<double> whole_float(std::string_view text);

/// The whole of `text` as a count, digits only; nothing if it is none or beyond 2^64 - 1.
std::optional<std::uint64_t> whole_count(std::string_view text);

/// The text in double quotes, at most 40 characters of it, unprintable ones shown as '?'.
std::string quote_text(std::string_view text);

}  // namespace stream_recon
