// Block files: records come back bit for bit, and no damage goes unnoticed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <functional>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "io/error.h"
#include "io/record_file.h"
#include "tests/io_test_folder.h"

namespace stream_recon {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

struct Sample {
  double x = 0;
  double y = 0;
  double z = 0;
  std::uint64_t id = 0;
  bool operator==(const Sample&) const = default;
};

std::vector<Sample> make_samples(std::size_t count, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  std::vector<Sample> samples(count);
  for (Sample& s : samples)
    s = {coordinate(random), coordinate(random), coordinate(random), random()};
  return samples;
}

void write_file(const std::string& path, const std::vector<Sample>& samples,
                std::size_t block_bytes, const BlockBatch& batch = {}) {
  RecordWriter<Sample> writer(File::create(path), block_bytes, batch);
  // Uneven pieces, so that they straddle the blocks.
  for (std::size_t at = 0, step = 1; at < samples.size(); at += step, step = step * 3 % 101 + 1) {
    writer.append(std::span(samples).subspan(at, std::min(step, samples.size() - at)));
  }
  writer.finish();
}

std::vector<Sample> read_file(const std::string& path) {
  const RecordFile<Sample> file(File::open(path));
  RecordCursor<Sample> cursor(file);
  std::vector<Sample> samples(file.record_count());
  EXPECT_EQ(cursor.read(samples), samples.size());
  return samples;
}

TEST(BlockFile, GivesBackEveryRecordForAnyCountAndBlockSize) {
  for (const std::size_t count : {0, 1, 7, 8, 9, 64, 1000, 5000}) {
    for (const std::size_t block_bytes : {32, 33, 256, 4096, 1 << 20}) {
      SCOPED_TRACE(std::to_string(count) + " records, blocks of " + std::to_string(block_bytes));
      const TestFolder folder;
      const auto samples = make_samples(count, 1);
      write_file(folder / "a", samples, block_bytes);
      EXPECT_EQ(read_file(folder / "a"), samples);
    }
  }
}

TEST(BlockFile, HasTheSameBytesHoweverManyBlocksAreEncodedTogether) {
  const auto last_first = [](std::size_t count, const std::function<void(std::size_t)>& body) {
    while (count > 0) body(--count);
  };
  for (const std::size_t count : {0, 1, 31, 32, 33, 128, 1000}) {
    const TestFolder folder;
    const auto samples = make_samples(count, 2);
    write_file(folder / "one", samples, 1024);
    for (const std::size_t blocks : {0, 2, 4, 100}) {
      const std::string path = folder / std::to_string(blocks);
      write_file(path, samples, 1024, {blocks, last_first});
      EXPECT_EQ(file_bytes(path), file_bytes(folder / "one")) << count << " in " << blocks;
    }
  }
}

TEST(BlockFile, GivesBackRecordsAtRandom) {
  const TestFolder folder;
  const auto samples = make_samples(3000, 2);
  write_file(folder / "a", samples, 1000);
  const RecordFile<Sample> file(File::open(folder / "a"));
  RecordCursor<Sample> cursor(file);
  std::mt19937 random(3);
  for (int i = 0; i < 500; ++i) {
    const std::size_t at = random() % samples.size();
    std::vector<Sample> some(1 + random() % 100);
    cursor.seek(at);
    const std::size_t got = cursor.read(some);
    ASSERT_EQ(got, std::min(some.size(), samples.size() - at));
    some.resize(got);
    ASSERT_TRUE(std::equal(some.begin(), some.end(), samples.begin() + static_cast<long>(at)));
  }
}

template <std::size_t kSize>
void expect_round_trip(bool is_noise) {
  SCOPED_TRACE(std::to_string(kSize) + (is_noise ? " noise" : " repeats"));
  using Record = std::array<std::byte, kSize>;
  std::mt19937 random(4);
  std::vector<Record> records(777);
  for (Record& record : records) {
    for (std::byte& b : record) b = is_noise ? static_cast<std::byte>(random()) : std::byte{7};
  }
  const TestFolder folder;
  RecordWriter<Record> writer(File::create(folder / "a"), 1024);
  writer.append(records);
  writer.finish();
  const RecordFile<Record> file(File::open(folder / "a"));
  std::vector<Record> read(records.size());
  EXPECT_EQ(RecordCursor<Record>(file).read(read), records.size());
  EXPECT_EQ(read, records);
}

TEST(BlockFile, TakesRecordsOfAnySizeAndNoiseAsWellAsRepeats) {
  for (const bool is_noise : {false, true}) {
    expect_round_trip<1>(is_noise);
    expect_round_trip<4>(is_noise);
    expect_round_trip<7>(is_noise);
    expect_round_trip<8>(is_noise);
    expect_round_trip<12>(is_noise);
    expect_round_trip<40>(is_noise);
  }
}

TEST(BlockFile, NoiseTakesLittleMoreThanItsBytes) {
  const TestFolder folder;
  std::mt19937_64 random(5);
  std::vector<std::uint64_t> noise(100000);
  for (auto& word : noise) word = random();
  RecordWriter<std::uint64_t> writer(File::create(folder / "a"), 65536);
  writer.append(noise);
  writer.finish();
  EXPECT_LT(File::open(folder / "a").size(), noise.size() * 8 * 1.002);
}

TEST(BlockFile, WritesTheSameBytesForTheSameRecords) {
  const TestFolder folder;
  const auto samples = make_samples(1000, 6);
  write_file(folder / "a", samples, 4096);
  RecordWriter<Sample> at_once(File::create(folder / "b"), 4096);
  at_once.append(samples);
  at_once.finish();
  EXPECT_EQ(file_bytes(folder / "a"), file_bytes(folder / "b"));
}

class DamagedBlockFile : public testing::Test {
 protected:
  DamagedBlockFile() {
    // Some blocks compress (equal records), some are stored (one block of noise).
    std::vector<Sample> samples(20, Sample{1, 2, 3, 4});
    for (const Sample& s : make_samples(8, 7)) samples.push_back(s);
    write_file(folder_ / "a", samples, 256);
    bytes_ = file_bytes(folder_ / "a");
  }

  /// Reads `bytes` as a file to its end.
  void read(const std::string& bytes) {
    put_bytes(folder_ / "damaged", bytes);
    read_file(folder_ / "damaged");
  }

  TestFolder folder_;
  std::string bytes_;
};

TEST_F(DamagedBlockFile, IsNoticedAtEveryTruncationLength) {
  ASSERT_NO_THROW(read(bytes_));
  for (std::size_t length = 0; length < bytes_.size(); ++length) {
    EXPECT_THROW(read(bytes_.substr(0, length)), IoError) << "length " << length;
  }
}

TEST_F(DamagedBlockFile, IsNoticedForEveryFlippedByteAndBit) {
  for (std::size_t at = 0; at < bytes_.size(); ++at) {
    for (const int mask : {0xff, 0x01, 0x80}) {
      std::string damaged = bytes_;
      damaged[at] = static_cast<char>(damaged[at] ^ mask);
      EXPECT_THROW(read(damaged), IoError) << "byte " << at << ", mask " << mask;
    }
  }
}

TEST_F(DamagedBlockFile, IsNoticedWhenBytesAreAddedOrBlocksExchanged) {
  EXPECT_THROW(read(bytes_ + "x"), IoError);
  EXPECT_THROW(read(bytes_ + bytes_), IoError);
  // The first two blocks hold equal records, so they differ in nothing but their numbers.
  std::uint32_t stored = 0;
  std::memcpy(&stored, bytes_.data() + 24 + 16, sizeof stored);
  const std::size_t block = 32 + stored;
  std::string exchanged = bytes_;
  exchanged.replace(24, block, bytes_.substr(24 + block, block));
  exchanged.replace(24 + block, block, bytes_.substr(24, block));
  ASSERT_NE(exchanged, bytes_);
  EXPECT_THROW(read(exchanged), IoError);
}

TEST_F(DamagedBlockFile, IsNamedWithBlockAndByte) {
  std::string damaged = bytes_;
  damaged[24 + 32] = static_cast<char>(~damaged[24 + 32]);
  EXPECT_THAT([&] { read(damaged); },
              ThrowsMessage<IoError>(AllOf(HasSubstr("/damaged"), HasSubstr("block 0"),
                                           HasSubstr("byte 24"), HasSubstr("run again"))));
}

TEST_F(DamagedBlockFile, IsRefusedWhenItsRecordsAreOfAnotherType) {
  EXPECT_THAT([&] { RecordFile<std::uint64_t>(File::open(folder_ / "a")); },
              ThrowsMessage<IoError>(HasSubstr("records of 32 bytes, not 8")));
}

TEST(BlockFile, CannotBeOpenedBeforeFinish) {
  const TestFolder folder;
  RecordWriter<Sample> writer(File::create(folder / "a"), 256);
  writer.append(make_samples(100, 8));
  EXPECT_THROW(RecordFile<Sample>(File::open(folder / "a")), IoError);
}

TEST(BlockFile, RefusesBlocksThatHoldNoRecord) {
  const TestFolder folder;
  EXPECT_THROW(RecordWriter<Sample>(File::create(folder / "a"), 31), std::invalid_argument);
}

}  // namespace
}  // namespace stream_recon
