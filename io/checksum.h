// A 64-bit checksum for data at rest.
//
// Guarantees: a change confined to one aligned 8-byte word is always noticed, any other but for a
// chance of about 2^-64; the same value on every machine. Not a defence against malice.
// Cost: about 5 GB/s. Memory: none. Thread rule: pure function.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace stream_recon {

/// The checksum of `data`; chain pieces by passing the sum before as `seed`.
std::uint64_t checksum64(std::span<const std::byte> data, std::uint64_t seed = 0);

}  // namespace stream_recon
