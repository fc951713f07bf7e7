// Sizes in bytes as people write and read them: 512M, 1.5G.
//
// Guarantees: units are powers of 1024; parse_size(size_argument(n)) is n rounded up to a whole
// MiB. Thread rule: pure functions.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace stream_recon {

/// Reads digits, perhaps a fraction, perhaps one of K M G T (either case), perhaps a final B or iB.
/// Nothing for other text, zero, or more than 2^63 bytes.
std::optional<std::uint64_t> parse_size(std::string_view text);

/// For messages: "1.5 GiB".
std::string size_text(std::uint64_t bytes);

/// For the command line: the next whole MiB, "1536M".
std::string size_argument(std::uint64_t bytes);

}  // namespace stream_recon
