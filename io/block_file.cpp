#include "io/block_file.h"

#include <algorithm>
#include <cassert>
#include <cstring>
#include <limits>
#include <string>
#include <utility>

#include "io/block_file_layout.h"
#include "io/checksum.h"
#include "io/error.h"

namespace stream_recon {
namespace {

constexpr std::uint64_t kNoBlock = std::numeric_limits<std::uint64_t>::max();

template <class Struct>
std::span<std::byte> bytes_of(Struct& object) {
  return std::as_writable_bytes(std::span(&object, 1));
}

template <class Struct>
bool is_sealed(Struct& object, std::uint64_t seed) {
  const auto before = bytes_of(object).first(sizeof(Struct) - sizeof object.checksum);
  return object.magic == Struct{}.magic && object.checksum == checksum64(before, seed);
}

std::uint64_t blocks_for(std::uint64_t records, std::uint64_t records_per_block) {
  return records / records_per_block + (records % records_per_block != 0 ? 1 : 0);
}

}  // namespace

BlockFile::BlockFile(File file, std::size_t record_bytes)
    : file_(std::move(file)), record_bytes_(record_bytes) {
  const std::uint64_t size = file_.size();
  detail::FileHeader header;
  detail::FileTrailer trailer;
  if (size < sizeof header + sizeof trailer) fail("is cut short", size);
  file_.read_at(0, bytes_of(header));
  if (!is_sealed(header, 0)) fail("is not a block file, or damaged,", 0);
  if (header.record_bytes != record_bytes || header.records_per_block == 0) {
    fail("holds records of " + std::to_string(header.record_bytes) + " bytes, not " +
             std::to_string(record_bytes) + ",",
         8);
  }
  records_per_block_ = header.records_per_block;

  const std::uint64_t index_end = size - sizeof trailer;
  file_.read_at(index_end, bytes_of(trailer));
  const std::uint64_t index_bytes = index_end - trailer.index_offset;
  if (trailer.magic != detail::FileTrailer{}.magic || trailer.index_offset > index_end ||
      index_bytes % sizeof(std::uint64_t) != 0 ||
      trailer.block_count != index_bytes / sizeof(std::uint64_t) ||
      trailer.block_count != blocks_for(trailer.record_count, records_per_block_)) {
    fail("is not complete: its index is missing or damaged", index_end);
  }
  offsets_.resize(trailer.block_count);
  file_.read_at(trailer.index_offset, std::as_writable_bytes(std::span(offsets_)));
  if (!is_sealed(trailer, checksum64(std::as_bytes(std::span(offsets_))))) {
    fail("has a damaged index", trailer.index_offset);
  }
  record_count_ = trailer.record_count;
  offsets_.push_back(trailer.index_offset);
}

void BlockFile::fail(const std::string& what, std::uint64_t byte) const {
  throw IoError(file_.path() + " " + what + " at byte " + std::to_string(byte) +
                "; the disk or another program changed it: check the disk and run again");
}

std::size_t BlockFile::records_in_block(std::uint64_t block) const {
  assert(block < block_count());
  return static_cast<std::size_t>(
      std::min<std::uint64_t>(records_per_block_, record_count_ - block * records_per_block_));
}

std::size_t BlockFile::read_block(std::uint64_t block, BlockCodec& codec,
                                  std::vector<std::byte>& stored, std::span<std::byte> out) const {
  const std::size_t records = records_in_block(block);
  const std::size_t raw_bytes = records * record_bytes_;
  assert(out.size() >= raw_bytes);
  detail::BlockHeader header;
  stored.resize(offsets_[block + 1] - offsets_[block]);
  file_.read_at(offsets_[block], stored);
  std::memcpy(&header, stored.data(), sizeof header);
  const auto payload = std::span<const std::byte>(stored).subspan(sizeof header);
  const bool is_intact =
      is_sealed(header, checksum64(payload)) && header.stored_bytes == payload.size() &&
      header.record_count == records && header.raw_bytes == raw_bytes &&
      header.number == static_cast<std::uint32_t>(block) &&
      codec.decode(BlockEncoding{header.encoding}, payload, record_bytes_, out.first(raw_bytes));
  if (!is_intact) fail("is damaged in block " + std::to_string(block), offsets_[block]);
  return records;
}

BlockCursor::BlockCursor(const BlockFile& file)
    : file_(&file),
      records_(std::min<std::uint64_t>(file.records_per_block(), file.record_count()) *
               file.record_bytes()),
      loaded_(kNoBlock) {}

std::span<const std::byte> BlockCursor::block(std::uint64_t number) {
  if (number != loaded_) {
    loaded_ = kNoBlock;
    loaded_bytes_ = file_->read_block(number, codec_, stored_, records_) * file_->record_bytes();
    loaded_ = number;
  }
  return std::span(records_).first(loaded_bytes_);
}

std::size_t BlockCursor::read(std::span<std::byte> out) {
  std::size_t filled = 0;
  while (out.size() - filled >= file_->record_bytes() && next_ < file_->record_count()) {
    const auto records = block(next_ / file_->records_per_block())
                             .subspan(next_ % file_->records_per_block() * file_->record_bytes());
    const std::size_t room = (out.size() - filled) / file_->record_bytes() * file_->record_bytes();
    const auto part = records.first(std::min(records.size(), room));
    std::memcpy(out.data() + filled, part.data(), part.size());
    filled += part.size();
    next_ += part.size() / file_->record_bytes();
  }
  return filled;
}

std::size_t BlockCursor::memory_bytes() const {
  return records_.capacity() + stored_.capacity() + codec_.memory_bytes();
}

}  // namespace stream_recon
