#include "io/vtk_xml_blocks.h"

#include <libdeflate.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstdint>
#include <new>

namespace stream_recon {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers go to disk as they are");

constexpr std::uint64_t kBlockBytes = std::uint64_t{1} << 20;
// Level 1 is a third faster but leaves 9 % more; level 6 takes off 1 % more (docs/formats.md).
constexpr int kLevel = 2;

}  // namespace

struct VtkXmlBlocks::Compressor {
  struct Free {
    void operator()(libdeflate_compressor* c) const { libdeflate_free_compressor(c); }
  };
  std::unique_ptr<libdeflate_compressor, Free> handle{libdeflate_alloc_compressor(kLevel)};
};

VtkXmlBlocks::VtkXmlBlocks() : compressor_(std::make_unique<Compressor>()) {
  if (compressor_->handle == nullptr) throw std::bad_alloc();
}
VtkXmlBlocks::~VtkXmlBlocks() = default;

void VtkXmlBlocks::begin(std::uint64_t raw_bytes, File& file) {
  file_ = &file;
  header_at_ = file.position();
  rest_ = raw_bytes;
  // Number of blocks, their size, the size of the last if it is not full, all compressed sizes.
  header_ = {(raw_bytes + kBlockBytes - 1) / kBlockBytes, kBlockBytes, raw_bytes % kBlockBytes};
  std::vector<std::uint64_t> unknown = header_;
  unknown.resize(header_.size() + header_[0]);
  file.write(std::as_bytes(std::span(unknown)));
}

void VtkXmlBlocks::put(std::span<const std::byte> raw) {
  assert(raw.size() <= rest_);
  rest_ -= raw.size();
  while (!raw.empty()) {
    const auto part = raw.first(std::min<std::size_t>(raw.size(), kBlockBytes - pending_.size()));
    raw = raw.subspan(part.size());
    if (part.size() == kBlockBytes) {
      write_block(part);
      continue;
    }
    pending_.insert(pending_.end(), part.begin(), part.end());
    if (pending_.size() == kBlockBytes) {
      write_block(pending_);
      pending_.clear();
    }
  }
}

void VtkXmlBlocks::end() {
  assert(rest_ == 0);
  if (!pending_.empty()) write_block(pending_);
  pending_.clear();
  file_->write_at(header_at_, std::as_bytes(std::span(header_)));
}

void VtkXmlBlocks::write_block(std::span<const std::byte> raw) {
  auto* const compressor = compressor_->handle.get();
  compressed_.resize(libdeflate_zlib_compress_bound(compressor, raw.size()));
  const std::size_t size = libdeflate_zlib_compress(compressor, raw.data(), raw.size(),
                                                    compressed_.data(), compressed_.size());
  header_.push_back(size);
  file_->write(std::span(compressed_).first(size));
}

}  // namespace stream_recon
