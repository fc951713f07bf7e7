#include "spatial/page_memory.h"

#include <sys/mman.h>

#include <new>

namespace stream_recon {

void* grow_pages(void* block, std::size_t old_bytes, std::size_t new_bytes) {
  void* grown = block == nullptr ? mmap(nullptr, new_bytes, PROT_READ | PROT_WRITE,
                                        MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0)
                                 : mremap(block, old_bytes, new_bytes, MREMAP_MAYMOVE);
  if (grown == MAP_FAILED) throw std::bad_alloc();
  return grown;
}

void release_pages(void* block, std::size_t bytes) noexcept {
  if (block != nullptr) munmap(block, bytes);
}

}  // namespace stream_recon
