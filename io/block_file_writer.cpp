#include <algorithm>
#include <stdexcept>
#include <utility>

#include "io/block_file.h"
#include "io/block_file_layout.h"
#include "io/checksum.h"

namespace stream_recon {
namespace {

constexpr std::size_t kLargestBlock = std::size_t{1} << 30;

std::size_t whole_records(const BlockFileOptions& options) {
  if (options.record_bytes == 0 || options.block_bytes < options.record_bytes ||
      options.block_bytes > kLargestBlock) {
    throw std::invalid_argument("a block must hold at least one record and at most 1 GiB");
  }
  return options.block_bytes - options.block_bytes % options.record_bytes;
}

template <class Struct>
std::span<const std::byte> bytes_of(const Struct& object) {
  return std::as_bytes(std::span(&object, 1));
}

/// Sets the checksum, the last member, from the members before it.
template <class Struct>
void seal(Struct& object, std::uint64_t seed) {
  object.checksum =
      checksum64(bytes_of(object).first(sizeof(Struct) - sizeof object.checksum), seed);
}

}  // namespace

BlockFileWriter::BlockFileWriter(File file, const BlockFileOptions& options)
    : file_(std::move(file)),
      record_bytes_(options.record_bytes),
      block_bytes_(whole_records(options)) {
  pending_.reserve(block_bytes_);
  detail::FileHeader header;
  header.record_bytes = static_cast<std::uint32_t>(record_bytes_);
  header.records_per_block = static_cast<std::uint32_t>(block_bytes_ / record_bytes_);
  seal(header, 0);
  file_.write(bytes_of(header));
}

void BlockFileWriter::append(std::span<const std::byte> records) {
  record_count_ += records.size() / record_bytes_;
  while (!records.empty()) {
    const auto part = records.first(std::min(records.size(), block_bytes_ - pending_.size()));
    pending_.insert(pending_.end(), part.begin(), part.end());
    records = records.subspan(part.size());
    if (pending_.size() == block_bytes_) write_block();
  }
}

void BlockFileWriter::write_block() {
  const EncodedBlock encoded = codec_.encode(pending_, record_bytes_);
  detail::BlockHeader header;
  header.encoding = static_cast<std::uint32_t>(encoded.encoding);
  header.record_count = static_cast<std::uint32_t>(pending_.size() / record_bytes_);
  header.raw_bytes = static_cast<std::uint32_t>(pending_.size());
  header.stored_bytes = static_cast<std::uint32_t>(encoded.bytes.size());
  header.number = static_cast<std::uint32_t>(offsets_.size());
  seal(header, checksum64(encoded.bytes));
  offsets_.push_back(file_.position());
  file_.write(bytes_of(header));
  file_.write(encoded.bytes);
  pending_.clear();
}

void BlockFileWriter::finish() {
  if (!pending_.empty()) write_block();
  const auto index = std::as_bytes(std::span(offsets_));
  detail::FileTrailer trailer;
  trailer.index_offset = file_.position();
  trailer.block_count = offsets_.size();
  trailer.record_count = record_count_;
  seal(trailer, checksum64(index));
  file_.write(index);
  file_.write(bytes_of(trailer));
  file_.close();
}

std::size_t BlockFileWriter::memory_bytes() const {
  return pending_.capacity() + offsets_.capacity() * sizeof offsets_[0] + codec_.memory_bytes();
}

}  // namespace stream_recon
