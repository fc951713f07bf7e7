// What the operating system says about this process' memory, and how to give memory back to it.
//
// Thread rule: all calls are thread-safe. Cost: a read of a small file in /proc.
#pragma once

#include <cstdint>

namespace stream_recon {

/// Largest resident set of the process so far, bytes.
std::uint64_t peak_resident_bytes();

/// Resident set now, bytes.
std::uint64_t resident_bytes();

/// Memory of the machine, bytes, or of the control group the process runs in where that is less.
std::uint64_t physical_memory_bytes();

/// Makes the allocator return large blocks to the system as soon as they are freed, so that the
/// resident set follows the reservations. Call once, before large allocations.
void make_allocator_return_memory();

/// Returns what small blocks have left behind.
void trim_allocator();

}  // namespace stream_recon
