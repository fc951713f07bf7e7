// Text for people in a page: names made safe, numbers with separators and units.
//
// Thread rule: pure functions.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace stream_recon::html {

/// Markup characters as entities, so that a name is shown and never read as markup, in attributes
/// too; control characters and what is no UTF-8 become U+FFFD.
std::string escape(std::string_view text);

/// "1,234,567".
std::string count(std::uint64_t number);
std::string count(std::int64_t number);
/// "12.3 s", "4 min 05 s", "2 h 03 min".
std::string duration(double seconds);
/// "28.6 MiB".
std::string bytes(std::uint64_t bytes);
/// "12.3 %"; nothing of nothing is 0.
std::string share(double part, double whole);

/// Bytes as text for a data: address (RFC 4648).
std::string base64(std::string_view bytes);

}  // namespace stream_recon::html
