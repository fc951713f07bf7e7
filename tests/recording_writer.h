// A surface writer that keeps what it is given.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <mutex>
#include <vector>

#include "io/surface_writer.h"

namespace stream_recon {

class RecordingWriter : public SurfaceWriter {
 public:
  explicit RecordingWriter(bool in_order) : in_order_(in_order) {}

  bool takes_chunks_in_order() const override { return in_order_; }
  void write(std::uint64_t number, const SurfaceChunk& chunk) override {
    const std::lock_guard lock(mutex_);
    if (in_order_) {
      EXPECT_EQ(number, chunks.size());
    }
    chunks.resize(std::max<std::size_t>(chunks.size(), number + 1));
    chunks[number] = chunk;
  }
  std::uint64_t bytes_written() const override { return 0; }

  std::vector<SurfaceChunk> chunks;

 private:
  void complete() override {}
  void publish() override {}

  bool in_order_;
  std::mutex mutex_;
};

}  // namespace stream_recon
