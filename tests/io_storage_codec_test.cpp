// What lies under block files: byte planes, the codec, the checksum.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "io/block_codec.h"
#include "io/byte_planes.h"
#include "io/checksum.h"

namespace stream_recon {
namespace {

using Bytes = std::vector<std::byte>;

Bytes make_noise(std::size_t size, unsigned seed) {
  std::mt19937 random(seed);
  Bytes noise(size);
  for (std::byte& b : noise) b = static_cast<std::byte>(random());
  return noise;
}

TEST(BytePlanes, PutByteOfRecordWhereItsPlaneHasTheRecord) {
  for (const std::size_t record : {4, 8, 12, 16, 20, 32}) {
    for (const std::size_t count : {0, 1, 7, 8, 9, 100}) {
      SCOPED_TRACE(std::to_string(count) + " records of " + std::to_string(record));
      const Bytes records = make_noise(record * count, 1);
      Bytes planes(records.size());
      split_planes(records, record, planes);
      for (std::size_t i = 0; i < records.size(); ++i) {
        ASSERT_EQ(planes[i % record * count + i / record], records[i]);
      }
      Bytes back(records.size());
      join_planes(planes, record, back);
      ASSERT_EQ(back, records);
    }
  }
}

TEST(BlockCodec, RefusesDamagedBlocksOrGivesBackABlockOfTheSameSize) {
  BlockCodec codec;
  Bytes raw(4096);
  for (std::size_t i = 0; i < raw.size(); ++i) raw[i] = static_cast<std::byte>(i % 37);
  const EncodedBlock encoded = codec.encode(raw, 8);
  ASSERT_EQ(encoded.encoding, BlockEncoding::kZstdPlanes);
  const Bytes stored(encoded.bytes.begin(), encoded.bytes.end());
  Bytes back(raw.size());
  ASSERT_TRUE(codec.decode(encoded.encoding, stored, 8, back));
  EXPECT_EQ(back, raw);
  // Nothing but the sanitizers can see a write outside the buffers here.
  for (std::size_t i = 0; i < stored.size(); ++i) {
    Bytes damaged = stored;
    damaged[i] ^= std::byte{0xff};
    codec.decode(encoded.encoding, damaged, 8, back);
  }
  Bytes shorter(raw.size() - 8);
  EXPECT_FALSE(codec.decode(encoded.encoding, stored, 8, shorter));
  EXPECT_FALSE(codec.decode(encoded.encoding, std::span(stored).first(stored.size() - 1), 8, back));
  EXPECT_FALSE(codec.decode(BlockEncoding::kStored, stored, 8, back));
  EXPECT_FALSE(codec.decode(BlockEncoding{99}, stored, 8, back));
}

TEST(BlockCodec, HoldsLittleMoreThanTwoBlocks) {
  BlockCodec codec;
  const Bytes raw = make_noise(1 << 20, 2);
  Bytes back(raw.size());
  const EncodedBlock encoded = codec.encode(raw, 32);
  codec.decode(encoded.encoding, encoded.bytes, 32, back);
  EXPECT_LT(codec.memory_bytes(), 2 * raw.size() + 1000000);
}

TEST(Checksum, ChangesWithEveryBitAndEveryLength) {
  const Bytes data = make_noise(100, 3);
  std::set<std::uint64_t> sums;
  for (std::size_t length = 0; length <= data.size(); ++length) {
    sums.insert(checksum64(std::span(data).first(length)));
  }
  EXPECT_EQ(sums.size(), data.size() + 1);
  for (std::size_t bit = 0; bit < data.size() * 8; ++bit) {
    Bytes changed = data;
    changed[bit / 8] ^= std::byte{1} << (bit % 8);
    sums.insert(checksum64(changed));
  }
  EXPECT_EQ(sums.size(), data.size() * 9 + 1);
}

TEST(Checksum, ChangesWithEveryPairOfBits) {
  const Bytes data = make_noise(96, 4);
  std::set<std::uint64_t> sums{checksum64(data)};
  for (std::size_t i = 0; i < data.size() * 8; ++i) {
    Bytes changed = data;
    changed[i / 8] ^= std::byte{1} << (i % 8);
    for (std::size_t j = 0; j < i; ++j) {
      changed[j / 8] ^= std::byte{1} << (j % 8);
      sums.insert(checksum64(changed));
      changed[j / 8] ^= std::byte{1} << (j % 8);
    }
  }
  EXPECT_EQ(sums.size(), 1 + data.size() * 8 * (data.size() * 8 - 1) / 2);
}

TEST(Checksum, TellsZerosOfDifferentLengthsApart) {
  const Bytes zeros(200);
  std::set<std::uint64_t> sums;
  for (std::size_t length = 0; length <= zeros.size(); ++length) {
    sums.insert(checksum64(std::span(zeros).first(length)));
  }
  EXPECT_EQ(sums.size(), zeros.size() + 1);
}

TEST(Checksum, StaysWhatFilesWereWrittenWith) {
  Bytes data(37);
  for (std::size_t i = 0; i < data.size(); ++i) data[i] = static_cast<std::byte>(i);
  EXPECT_EQ(checksum64(data), 0xc40c7b143e2d1837);
  EXPECT_EQ(checksum64(data, 1), 0xf422d18e42f9be90);
}

}  // namespace
}  // namespace stream_recon
