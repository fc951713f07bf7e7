#include "spatial/page_memory.h"

#include <sys/mman.h>

#include <cstring>
#include <new>

namespace stream_recon {
namespace {

void* new_pages(std::size_t bytes) {
  return mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE,
              -1, 0);
}

#if defined(__SANITIZE_THREAD__)
// The sanitizer does not see mremap, and takes pages that one thread gave back and another got for
// shared.
void* move_pages(void* block, std::size_t old_bytes, std::size_t new_bytes) {
  void* moved = new_pages(new_bytes);
  if (moved == MAP_FAILED) return moved;
  std::memcpy(moved, block, old_bytes);
  munmap(block, old_bytes);
  return moved;
}
#else
void* move_pages(void* block, std::size_t old_bytes, std::size_t new_bytes) {
  return mremap(block, old_bytes, new_bytes, MREMAP_MAYMOVE);
}
#endif

}  // namespace

void* grow_pages(void* block, std::size_t old_bytes, std::size_t new_bytes) {
  void* grown = block == nullptr ? new_pages(new_bytes) : move_pages(block, old_bytes, new_bytes);
  if (grown == MAP_FAILED) throw std::bad_alloc();
  return grown;
}

void release_pages(void* block, std::size_t bytes) noexcept {
  if (block != nullptr) munmap(block, bytes);
}

}  // namespace stream_recon
