// What threads share: the meter of scratch bytes, and one block file read by many.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdint>
#include <numeric>
#include <string>
#include <thread>
#include <vector>

#include "io/error.h"
#include "io/record_file.h"
#include "io/scratch_directory.h"
#include "tests/io_test_folder.h"

namespace stream_recon {
namespace {

constexpr int kThreads = 4;

TEST(StorageInParallel, OneBlockFileIsReadByManyThreads) {
  const TestFolder folder;
  ScratchDirectory scratch({folder.path()});
  std::vector<std::uint64_t> numbers(20000);
  std::iota(numbers.begin(), numbers.end(), 0);
  RecordWriter<std::uint64_t> writer(scratch.create("numbers"), 1024);
  writer.append(numbers);
  writer.finish();

  const RecordFile<std::uint64_t> file(scratch.open("numbers"));
  std::atomic<int> wrong{0};
  std::vector<std::jthread> threads;
  for (int t = 0; t < kThreads; ++t) {
    threads.emplace_back([&, t] {
      RecordCursor<std::uint64_t> cursor(file);
      std::vector<std::uint64_t> some(300);
      for (std::uint64_t i = 0; i < 200; ++i) {
        const std::uint64_t at = (i * 7919 + static_cast<std::uint64_t>(t) * 104729) % 19000;
        cursor.seek(at);
        if (cursor.read(some) != some.size() || some.front() != at) ++wrong;
      }
    });
  }
  threads.clear();
  EXPECT_EQ(wrong, 0);
}

TEST(StorageInParallel, NoThreadGetsBytesOverTheLimit) {
  const TestFolder folder;
  ScratchDirectory scratch({folder.path(), 1000});
  std::atomic<std::uint64_t> written{0};
  std::vector<std::jthread> threads;
  for (int t = 0; t < kThreads; ++t) {
    threads.emplace_back([&, t] {
      File file = scratch.create(std::to_string(t));
      const std::vector<std::byte> piece(7);
      try {
        for (;;) {
          file.write(piece);
          written += piece.size();
        }
      } catch (const IoError&) {  // the limit is reached
      }
    });
  }
  threads.clear();
  EXPECT_EQ(scratch.used_bytes(), written);
  EXPECT_EQ(scratch.peak_bytes(), written);
  EXPECT_EQ(written, 1000U / 7 * 7);
}

TEST(StorageInParallel, ScratchFilesComeAndGoInAllThreads) {
  const TestFolder folder;
  ScratchDirectory scratch({folder.path()});
  std::vector<std::jthread> threads;
  for (int t = 0; t < kThreads; ++t) {
    threads.emplace_back([&, t] {
      for (int i = 0; i < 50; ++i) {
        const std::string name = std::to_string(t) + "-" + std::to_string(i);
        scratch.create(name).write(std::vector<std::byte>(10));
        scratch.remove(name);
      }
    });
  }
  threads.clear();
  EXPECT_EQ(scratch.used_bytes(), 0U);
  EXPECT_LE(scratch.peak_bytes(), kThreads * 10U);
}

}  // namespace
}  // namespace stream_recon
