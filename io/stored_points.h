// Points on disk that are looked up by number, through a cache of blocks.
//
// Guarantees: points come back bit for bit. Memory: cache_bytes, at least about 0.3 MB, and 8
// bytes for each 1365 points. Cost: a block is read where the cache lacks it, about 20 us.
// Thread rule: one thread.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/record_file.h"
#include "io/scratch_directory.h"
#include "spatial/point.h"

namespace stream_recon {

class StoredPoints {
 public:
  /// Makes the file `name`, which is removed when the object goes. \throw IoError
  StoredPoints(ScratchDirectory& scratch, std::string name, std::uint64_t cache_bytes);
  ~StoredPoints() { scratch_.remove(name_); }
  StoredPoints(const StoredPoints&) = delete;
  StoredPoints& operator=(const StoredPoints&) = delete;

  /// \throw IoError
  void append(const Point3& point) { writer_->append(point); }
  /// No more points; from here on they can be looked up. \throw IoError
  void finish();

  std::uint64_t count() const { return file_->record_count(); }
  /// \pre number < count() \throw IoError
  const Point3& operator[](std::uint64_t number) {
    const std::uint64_t block = number / per_block_;
    Slot& slot = slots_[block % slots_.size()];
    if (slot.block != block) load(block, slot);
    return slot.points[number % per_block_];
  }

 private:
  struct Slot {
    std::uint64_t block = ~std::uint64_t{0};
    std::vector<Point3> points;
  };

  void load(std::uint64_t block, Slot& slot);

  ScratchDirectory& scratch_;
  std::string name_;
  std::optional<RecordWriter<Point3>> writer_;
  std::optional<RecordFile<Point3>> file_;
  std::optional<BlockCodec> codec_;
  std::vector<std::byte> stored_;
  std::vector<Slot> slots_;
  std::uint64_t per_block_ = 1;
};

}  // namespace stream_recon
