#include "engine/spacing/spacing_reader.h"

#include <algorithm>
#include <span>

#include "engine/windows/index_layout.h"

namespace stream_recon {
namespace {

constexpr std::uint64_t kPageBytes = sizeof(SpacingPage) + 128;  // of the cache and the allocator

}  // namespace

std::uint64_t SpacingCache::least_memory(unsigned readers) {
  return (std::uint64_t{readers} + 4) * 4 * kPageBytes;
}

std::uint64_t SpacingCache::most_memory(std::uint64_t point_count) {
  return index_layout::quotient_up(point_count, SpacingPage::kPoints) * kPageBytes;
}

std::uint64_t SpacingCache::memory(std::uint64_t point_count, unsigned readers,
                                   std::uint64_t available) {
  return std::min(most_memory(point_count), std::max(available / 24, least_memory(readers)));
}

SpacingCache::SpacingCache(const ScratchDirectory& scratch, const CloudIndex& index,
                           std::uint64_t memory)
    : scale_(index.scale),
      file_(scratch.open(kSpacings)),
      pages_(std::max<std::uint64_t>(1, memory / kPageBytes)) {}

void SpacingReader::load(std::uint64_t page) {
  pin_ = cache_.pages_.get(page, [&](SpacingPage& loaded) {
    const std::size_t count = cache_.file_.read_block(
        page, codec_, stored_, std::as_writable_bytes(std::span(loaded.spacing)));
    std::fill(loaded.spacing.begin() + static_cast<std::ptrdiff_t>(count), loaded.spacing.end(),
              0.0F);
  });
  page_ = page;
}

}  // namespace stream_recon
