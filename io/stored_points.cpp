#include "io/stored_points.h"

#include <algorithm>
#include <utility>

namespace stream_recon {
namespace {

constexpr std::size_t kBlock = std::size_t{32} << 10;

}  // namespace

StoredPoints::StoredPoints(ScratchDirectory& scratch, std::string name, std::uint64_t cache_bytes)
    : scratch_(scratch),
      name_(std::move(name)),
      writer_(std::in_place, scratch.create(name_), kBlock),
      slots_(std::max<std::uint64_t>(cache_bytes / kBlock, 8)) {}

void StoredPoints::finish() {
  writer_->finish();
  writer_.reset();
  file_.emplace(scratch_.open(name_));
  codec_.emplace();
  per_block_ = std::max<std::uint64_t>(file_->records_per_block(), 1);
}

void StoredPoints::load(std::uint64_t block, Slot& slot) {
  slot.points.resize(per_block_);
  slot.block = ~std::uint64_t{0};
  file_->read_block(block, *codec_, stored_, std::as_writable_bytes(std::span(slot.points)));
  slot.block = block;
}

}  // namespace stream_recon
