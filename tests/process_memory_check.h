// Whether a test may hold a program to its memory.
#pragma once

namespace stream_recon {

/// The sanitizers keep memory of their own beside the program's.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kMemoryIsOurs = false;
#else
inline constexpr bool kMemoryIsOurs = true;
#endif

}  // namespace stream_recon
