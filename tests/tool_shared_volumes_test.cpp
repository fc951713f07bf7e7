// The numbers that the README of the shared data tells about its volumes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "tests/io_test_folder.h"
#include "tests/volume_check.h"

namespace stream_recon {
namespace {

struct Expectation {
  std::string name;
  std::size_t boundary;
  std::function<bool(double)> is_inside;
};

class SharedVolume : public testing::TestWithParam<Expectation> {};

TEST_P(SharedVolume, HasTheBoundaryVoxelsThatAreKnown) {
  const std::string path = shared_data(GetParam().name);
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no shared data: " << path;
  const auto volume = open_volume(request_of({path}));
  EXPECT_EQ(count_boundary(*volume, GetParam().is_inside), GetParam().boundary);
}

auto above(double limit) {
  return [limit](double v) { return v > limit; };
}
auto is(double label) {
  return [label](double v) { return v == label; };
}

INSTANTIATE_TEST_SUITE_P(
    All, SharedVolume,
    testing::Values(Expectation{"volumes/engine_ct.nii.gz", 216519, above(100)},
                    Expectation{"volumes/engine_ct.nii.gz", 82217, above(150)},
                    Expectation{"volumes/abdominal_atlas_labels.nrrd", 331131, above(0)},
                    Expectation{"volumes/allen_human_brain_labels.nii.gz", 667824, above(0)},
                    Expectation{"volumes/frogtissue.mhd", 198422, is(13)},
                    Expectation{"volumes/frogtissue.mhd", 413251, above(0)},
                    Expectation{"stacks/vhf_head_ct_png", 206613, above(100)},
                    Expectation{"stacks/frog_masks_tiff/skeletonMasks.tiff", 198340, is(1)},
                    Expectation{"stacks/frog_masks_tiff/muscleMasks.tiff", 822268, above(0)}));

class SharedVolumeVoxels : public testing::TestWithParam<std::string> {};

TEST_P(SharedVolumeVoxels, AreThoseOfItk) {
  const std::string path = shared_data(GetParam());
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no shared data: " << path;
  const auto volume = open_volume(request_of({path}));
  const auto image = read_with_itk(path);
  const auto voxels = voxels_of(*volume);
  ASSERT_EQ(voxels.size(), image->GetLargestPossibleRegion().GetNumberOfPixels());
  EXPECT_TRUE(std::equal(voxels.begin(), voxels.end(), image->GetBufferPointer()));
}

INSTANTIATE_TEST_SUITE_P(All, SharedVolumeVoxels,
                         testing::Values("volumes/engine_ct.nii.gz",
                                         "volumes/abdominal_atlas_labels.nrrd",
                                         "volumes/allen_human_brain_labels.nii.gz"));

// The header says a CompressedDataSize below the file's; ITK believes it, and fills with zeros.
TEST(SharedFrog, IsReadWholeThoughItsHeaderIsWrong) {
  const std::string path = shared_data("volumes/frogtissue.mhd");
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no shared data: " << path;
  const TestFolder folder;
  std::string header = file_bytes(path);
  const std::string wrong = "CompressedDataSize = 260020";
  header.replace(header.find(wrong), wrong.size(), "CompressedDataSize = 262087");
  put_bytes(folder / "frogtissue.mhd", header);
  std::filesystem::copy(shared_data("volumes/frogtissue.zraw"), folder.path());
  const auto image = read_with_itk(folder / "frogtissue.mhd");
  const auto voxels = voxels_of(*open_volume(request_of({path})));
  ASSERT_EQ(voxels.size(), image->GetLargestPossibleRegion().GetNumberOfPixels());
  EXPECT_TRUE(std::equal(voxels.begin(), voxels.end(), image->GetBufferPointer()));
}

/// Unpacks a packed tar of the shared data; false if it is not there.
bool unpack(const std::string& name, const std::string& folder) {
  const std::string path = shared_data(name);
  return std::filesystem::exists(path) &&
         std::system(("tar -xf '" + path + "' -C '" + folder + "'").c_str()) == 0;
}

TEST(SharedStacks, ChestOfManyDicomFilesInMixedOrder) {
  const TestFolder folder;
  if (!unpack("stacks/chest_ct_dicom.tar.zst", folder.path())) GTEST_SKIP() << "no shared data";
  const auto volume = open_volume(request_of({folder / "chest_ct_dicom"}, true));
  const VolumeGeometry& geometry = volume->geometry();
  EXPECT_EQ(geometry.size, (std::array<std::size_t, 3>{512, 512, 130}));
  EXPECT_DOUBLE_EQ(geometry.step[0].x, 0.78125);
  EXPECT_DOUBLE_EQ(geometry.step[1].y, 0.78125);
  EXPECT_NEAR(std::abs(geometry.step[2].z), 1, 1e-9);
  EXPECT_EQ(count_boundary(*volume, [](double v) { return v >= -400; }), 870006U);
}

TEST(SharedStacks, HeadOfRawSlicesWithADetachedHeader) {
  const TestFolder folder;
  if (!unpack("stacks/ct_head_raw_slices.tar.gz", folder.path())) GTEST_SKIP() << "no shared data";
  const auto volume = open_volume(request_of({folder / "ct_head_raw_slices/quarter.nhdr"}, true));
  EXPECT_DOUBLE_EQ(volume->geometry().step[2].z, 1.5);
  EXPECT_EQ(count_boundary(*volume, above(1150)), 21211U);
}

}  // namespace
}  // namespace stream_recon
