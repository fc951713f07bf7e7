// How a line of a point text splits into columns, and which of them are x, y and z.
//
// Guarantees: nothing is guessed twice: the separator of the first line of numbers holds for the
// whole file, so decimal commas are met as errors and never read as two columns.
// Thread rule: immutable once made.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace stream_recon {

/// What separates columns: blanks and tabs alone, or one character with blanks around it.
enum class XyzSeparator : char { kBlank = ' ', kComma = ',', kSemicolon = ';' };

/// The separator a line uses; nothing where it has commas and semicolons.
std::optional<XyzSeparator> separator_of(std::string_view line);

/// The line without a trailing comment ("#" or "//" to the end) and blanks around it.
std::string_view without_comment(std::string_view line);

/// Takes the next column off the front of `rest`; false where none is left. A column between two
/// separators may be empty.
bool take_column(std::string_view& rest, XyzSeparator separator, std::string_view& column);

std::size_t count_columns(std::string_view line, XyzSeparator separator);

/// Positions of the columns named x, y, z ("X", "\"x\"", and ParaView's "Points:0" to "Points:2"
/// too) in a line of names; nothing unless each is there once.
std::optional<std::array<std::size_t, 3>> named_axes(std::string_view line);

}  // namespace stream_recon
