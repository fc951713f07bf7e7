// The framed point stream, `pts`, byte by byte (docs/formats.md).
//
// A header, frames of points, an end frame; each part carries its checksum. So a reader of a pipe
// knows that a stream whose writer was killed is not whole, whatever byte it ended at.
// All numbers are little endian.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace stream_recon {

/// As in PNG: notices transfers that change line ends, or strip the eighth bit.
inline constexpr std::string_view kPtsMagic{"\x89PTS\r\n\x1a\n", 8};
inline constexpr std::uint32_t kPtsVersion = 1;
inline constexpr std::uint32_t kPtsFrame = 0x4d415246;  ///< "FRAM"
inline constexpr std::uint32_t kPtsEnd = 0x21444e45;    ///< "END!"

/// Magic, version u32, bytes of a coordinate u32 (4 or 8), bytes of metadata u32, zero u32.
inline constexpr std::size_t kPtsHeaderBytes = 24;
/// Tag u32, points in the frame u32, points before the frame u64.
inline constexpr std::size_t kPtsFrameHeaderBytes = 16;
inline constexpr std::size_t kPtsChecksumBytes = 8;

inline constexpr std::uint32_t kPtsMaxMetadata = 1 << 20;  ///< bytes
inline constexpr std::uint32_t kPtsMaxFramePoints = 1 << 16;

}  // namespace stream_recon
