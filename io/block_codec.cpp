#include "io/block_codec.h"

#include <zstd.h>

#include <algorithm>
#include <new>

#include "io/byte_planes.h"

namespace stream_recon {
namespace {

// Level 3 takes off 0 to 7 % more of point data at 0.5 to 0.9 of the speed (docs/formats.md).
constexpr int kLevel = 1;

template <class Context>
Context* checked(Context* context) {
  if (context == nullptr) throw std::bad_alloc();
  return context;
}

}  // namespace

struct BlockCodec::Contexts {
  struct Free {
    void operator()(ZSTD_CCtx* context) const { ZSTD_freeCCtx(context); }
    void operator()(ZSTD_DCtx* context) const { ZSTD_freeDCtx(context); }
  };
  std::unique_ptr<ZSTD_CCtx, Free> compressor;
  std::unique_ptr<ZSTD_DCtx, Free> decompressor;
};

BlockCodec::BlockCodec() : contexts_(std::make_unique<Contexts>()) {}
BlockCodec::~BlockCodec() = default;
BlockCodec::BlockCodec(BlockCodec&&) noexcept = default;
BlockCodec& BlockCodec::operator=(BlockCodec&&) noexcept = default;

EncodedBlock BlockCodec::encode(std::span<const std::byte> raw, std::size_t record_bytes) {
  const bool has_planes = can_split_planes(record_bytes);
  if (has_planes) {
    planes_.resize(raw.size());
    split_planes(raw, record_bytes, planes_);
  }
  const std::span<const std::byte> source = has_planes ? planes_ : raw;
  auto& context = contexts_->compressor;
  if (context == nullptr) context.reset(checked(ZSTD_createCCtx()));
  // With less room than the raw block takes, zstd fails where compression does not pay.
  compressed_.resize(raw.size() - raw.size() / 32);
  const std::size_t size = ZSTD_compressCCtx(context.get(), compressed_.data(), compressed_.size(),
                                             source.data(), source.size(), kLevel);
  if (ZSTD_isError(size) != 0) return {BlockEncoding::kStored, raw};
  return {has_planes ? BlockEncoding::kZstdPlanes : BlockEncoding::kZstd,
          std::span(compressed_).first(size)};
}

bool BlockCodec::decode(BlockEncoding encoding, std::span<const std::byte> stored,
                        std::size_t record_bytes, std::span<std::byte> raw) {
  switch (encoding) {
    case BlockEncoding::kStored:
      if (stored.size() != raw.size()) return false;
      std::copy(stored.begin(), stored.end(), raw.begin());
      return true;
    case BlockEncoding::kZstd:
      return decompress(stored, raw);
    case BlockEncoding::kZstdPlanes:
      if (!can_split_planes(record_bytes) || raw.size() % record_bytes != 0) return false;
      planes_.resize(raw.size());
      if (!decompress(stored, planes_)) return false;
      join_planes(planes_, record_bytes, raw);
      return true;
  }
  return false;
}

bool BlockCodec::decompress(std::span<const std::byte> stored, std::span<std::byte> raw) {
  auto& context = contexts_->decompressor;
  if (context == nullptr) context.reset(checked(ZSTD_createDCtx()));
  const std::size_t size =
      ZSTD_decompressDCtx(context.get(), raw.data(), raw.size(), stored.data(), stored.size());
  return size == raw.size();  // an error code is larger than any size
}

std::size_t BlockCodec::memory_bytes() const {
  return planes_.capacity() + compressed_.capacity() +
         ZSTD_sizeof_CCtx(contexts_->compressor.get()) +
         ZSTD_sizeof_DCtx(contexts_->decompressor.get());
}

}  // namespace stream_recon
