// Voxels without a header.
#include <gtest/gtest.h>

#include "tests/io_test_folder.h"
#include "tests/volume_check.h"

namespace stream_recon {
namespace {

class RawVolume : public testing::Test {
 protected:
  RawVolume() {
    request_.needs_spacing = false;
    request_.raw = RawLayout{{3, 2, 2}, RawType::kInt16, false, 0};
    for (int n = 0; n < 12; ++n) {
      little_ += {static_cast<char>(n * 50), static_cast<char>(n * 50 >> 8)};
      big_ += {static_cast<char>(n * 50 >> 8), static_cast<char>(n * 50)};
      expected_.push_back(n * 50);
    }
  }

  std::string refused(std::vector<std::string> paths) {
    request_.paths = std::move(paths);
    return refusal(request_);
  }
  std::vector<double> read(std::vector<std::string> paths) {
    request_.paths = std::move(paths);
    return voxels_of(*open_volume(request_));
  }

  TestFolder folder_;
  VolumeRequest request_;
  std::string little_, big_;
  std::vector<double> expected_;
};

TEST_F(RawVolume, OneFileOrOneForEachSliceGivesTheVoxels) {
  put_bytes(folder_ / "all", little_);
  EXPECT_EQ(read({folder_ / "all"}), expected_);
  put_bytes(folder_ / "a", "head" + big_.substr(0, 12));
  put_bytes(folder_ / "b", "skip" + big_.substr(12));
  request_.raw->big_endian = true;
  request_.raw->skip = 4;
  EXPECT_EQ(read({folder_ / "a", folder_ / "b"}), expected_);
}

TEST_F(RawVolume, AFolderIsSortedByTheNumbersInTheNames) {
  request_.raw->dims = {6, 1, 12};
  std::vector<double> expected;
  for (int n = 0; n < 12; ++n) {
    std::string slice = little_;
    std::rotate(slice.begin(), slice.begin() + 2 * n, slice.end());
    put_bytes(folder_ / ("q." + std::to_string(n + 1)), slice.substr(0, 12));
    for (int i = 0; i < 6; ++i) expected.push_back((n + i) % 12 * 50);
  }
  put_bytes(folder_ / "q.nhdr", "a header");
  put_bytes(folder_ / "README", "a text");
  EXPECT_EQ(read({folder_.path()}), expected);
  std::filesystem::remove(folder_ / "q.5");
  EXPECT_NE(refused({folder_.path()}).find("q.5 is missing between q.4 and q.6"),
            std::string::npos);
}

TEST_F(RawVolume, EveryTypeIsRead) {
  request_.raw->dims = {1, 1, 1};
  const auto expect = [&](RawType type, const std::string& bytes, double value) {
    put_bytes(folder_ / "v", bytes);
    request_.raw->type = type;
    request_.raw->big_endian = true;
    EXPECT_EQ(read({folder_ / "v"}), std::vector<double>{value});
    put_bytes(folder_ / "v", std::string(bytes.rbegin(), bytes.rend()));
    request_.raw->big_endian = false;
    EXPECT_EQ(read({folder_ / "v"}), std::vector<double>{value});
  };
  using namespace std::string_literals;
  expect(RawType::kUint8, "\xfe"s, 254);
  expect(RawType::kInt8, "\xfe"s, -2);
  expect(RawType::kUint16, "\xff\x01"s, 0xff01);
  expect(RawType::kInt16, "\xff\x01"s, -255);
  expect(RawType::kUint32, "\xff\0\0\1"s, 0xff000001);
  expect(RawType::kInt32, "\xff\xff\xff\xfd"s, -3);
  expect(RawType::kFloat32, "\xc0\x20\0\0"s, -2.5);
  expect(RawType::kFloat64, "\x3f\xe8\0\0\0\0\0\0"s, 0.75);
}

TEST_F(RawVolume, AnyOtherLengthIsRefusedWithBothNumbers) {
  put_bytes(folder_ / "v", little_ + "x");
  EXPECT_NE(refused({folder_ / "v"}).find("25 bytes instead of 24"), std::string::npos);
  for (std::size_t left = 0; left < little_.size(); ++left) {
    put_bytes(folder_ / "v", little_.substr(0, left));
    EXPECT_NE(refused({folder_ / "v"}).find(std::to_string(left) + " bytes instead of 24"),
              std::string::npos);
  }
  EXPECT_NE(refused({folder_ / "v", folder_ / "v", folder_ / "v"}).find("3 raw files for 2 slices"),
            std::string::npos);
}

TEST_F(RawVolume, SpacingIsUnknownUnlessGiven) {
  put_bytes(folder_ / "v", little_);
  request_.needs_spacing = true;
  EXPECT_NE(refused({folder_ / "v"}).find("--spacing"), std::string::npos);
  request_.spacing = {1, 2, 3};
  EXPECT_EQ(open_volume(request_)->geometry().position(1, 1, 1), (Point3{1, 2, 3}));
}

TEST_F(RawVolume, AWrongRequestIsAUsageError) {
  EXPECT_THROW(open_volume({}), std::invalid_argument);
  put_bytes(folder_ / "v", little_);
  request_.paths = {folder_ / "v"};
  request_.spacing = {1, 0, 1};
  EXPECT_THROW(open_volume(request_), std::invalid_argument);
  request_.spacing.reset();
  request_.raw->dims[1] = 0;
  EXPECT_THROW(open_volume(request_), std::invalid_argument);
  request_.raw->dims = {std::size_t{1} << 40, std::size_t{1} << 40, 3};
  EXPECT_THROW(open_volume(request_), InputError);
}

}  // namespace
}  // namespace stream_recon
