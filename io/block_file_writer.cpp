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

/// One block of the batch: its records, then what goes to the file.
struct BlockFileWriter::Block {
  std::vector<std::byte> records;
  BlockCodec codec;
  detail::BlockHeader header;
  std::span<const std::byte> stored;  ///< of the records or the codec
};

BlockFileWriter::BlockFileWriter(File file, const BlockFileOptions& options)
    : file_(std::move(file)),
      record_bytes_(options.record_bytes),
      block_bytes_(whole_records(options)),
      loop_(options.batch.loop),
      batch_(std::max<std::size_t>(options.batch.blocks, 1)) {
  for (Block& block : batch_) block.records.reserve(block_bytes_);
  detail::FileHeader header;
  header.record_bytes = static_cast<std::uint32_t>(record_bytes_);
  header.records_per_block = static_cast<std::uint32_t>(block_bytes_ / record_bytes_);
  seal(header, 0);
  file_.write(bytes_of(header));
}

BlockFileWriter::~BlockFileWriter() = default;
BlockFileWriter::BlockFileWriter(BlockFileWriter&&) noexcept = default;
BlockFileWriter& BlockFileWriter::operator=(BlockFileWriter&&) noexcept = default;

void BlockFileWriter::append(std::span<const std::byte> records) {
  record_count_ += records.size() / record_bytes_;
  while (!records.empty()) {
    auto& pending = batch_[filling_].records;
    const auto part = records.first(std::min(records.size(), block_bytes_ - pending.size()));
    pending.insert(pending.end(), part.begin(), part.end());
    records = records.subspan(part.size());
    if (pending.size() == block_bytes_) ++filling_;
    if (filling_ == batch_.size()) write_batch();
  }
}

void BlockFileWriter::encode(Block& block, std::uint64_t number) const {
  const EncodedBlock encoded = block.codec.encode(block.records, record_bytes_);
  block.stored = encoded.bytes;
  block.header = {};
  block.header.encoding = static_cast<std::uint32_t>(encoded.encoding);
  block.header.record_count = static_cast<std::uint32_t>(block.records.size() / record_bytes_);
  block.header.raw_bytes = static_cast<std::uint32_t>(block.records.size());
  block.header.stored_bytes = static_cast<std::uint32_t>(encoded.bytes.size());
  block.header.number = static_cast<std::uint32_t>(number);
  seal(block.header, checksum64(encoded.bytes));
}

void BlockFileWriter::write_batch() {
  const std::size_t partial = filling_ < batch_.size() && !batch_[filling_].records.empty() ? 1 : 0;
  const auto blocks = std::span(batch_).first(filling_ + partial);
  const std::uint64_t first = offsets_.size();
  loop_(blocks.size(), [&](std::size_t i) { encode(blocks[i], first + i); });
  for (Block& block : blocks) {
    offsets_.push_back(file_.position());
    file_.write(bytes_of(block.header));
    file_.write(block.stored);
    block.records.clear();
  }
  filling_ = 0;
}

void BlockFileWriter::finish() {
  write_batch();
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
  std::size_t bytes = offsets_.capacity() * sizeof offsets_[0];
  for (const Block& block : batch_) bytes += block.records.capacity() + block.codec.memory_bytes();
  return bytes;
}

}  // namespace stream_recon
