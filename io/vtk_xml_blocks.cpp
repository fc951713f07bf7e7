#include "io/vtk_xml_blocks.h"

#include <libdeflate.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
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

void VtkXmlBlocks::append(std::span<const std::byte> raw, std::vector<std::byte>& out) {
  auto* const compressor = compressor_->handle.get();
  // Number of blocks, their size, the size of the last if it is not full, all compressed sizes.
  std::vector<std::uint64_t> header{(raw.size() + kBlockBytes - 1) / kBlockBytes, kBlockBytes,
                                    raw.size() % kBlockBytes};
  const std::size_t header_bytes = (3 + header[0]) * sizeof(std::uint64_t);
  const std::size_t header_at = out.size();
  out.resize(header_at + header_bytes);
  for (; !raw.empty(); raw = raw.subspan(std::min<std::size_t>(raw.size(), kBlockBytes))) {
    const auto part = raw.first(std::min<std::size_t>(raw.size(), kBlockBytes));
    block_.resize(libdeflate_zlib_compress_bound(compressor, part.size()));
    const std::size_t size = libdeflate_zlib_compress(compressor, part.data(), part.size(),
                                                      block_.data(), block_.size());
    header.push_back(size);
    out.insert(out.end(), block_.begin(), block_.begin() + static_cast<std::ptrdiff_t>(size));
  }
  std::memcpy(out.data() + header_at, header.data(), header_bytes);
}

}  // namespace stream_recon
