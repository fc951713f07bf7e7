// Memory by the page, straight from the system: what GrowableArray grows in.
#pragma once

#include <cstddef>

namespace stream_recon {

/// Enlarges a block of `old_bytes` (0 with nullptr: a new one) to `new_bytes`. The new part reads
/// as zero and is not resident until written; the old part keeps its pages, perhaps at a new
/// address. \throw std::bad_alloc the system has no address space to give; the old block is
/// unchanged
void* grow_pages(void* block, std::size_t old_bytes, std::size_t new_bytes);

/// Gives a block back to the system; nothing happens for nullptr.
void release_pages(void* block, std::size_t bytes) noexcept;

}  // namespace stream_recon
