// slices-to-points as a user calls it: real volumes, pipes, errors, memory.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <filesystem>
#include <random>
#include <string>

#include "tests/cli_program.h"

namespace stream_recon {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const std::string kData = STREAM_RECON_SHARED_DATA;

std::string metaimage(const std::string& size, const std::string& data) {
  return "ObjectType = Image\nNDims = 3\nDimSize = " + size +
         "\nElementSpacing = 0.5 0.5 1.5\nOffset = 10 20 30\nElementType = MET_UCHAR\n"
         "ElementDataFile = " +
         data + "\n";
}

class Converter : public testing::Test {
 protected:
  /// A volume with a box of label 7 and, beside it, one of label 9; the last one a voxel thick.
  void SetUp() override {
    std::string voxels(40 * 40 * 40, '\0');
    for (std::size_t at = 0; at < voxels.size(); ++at) {
      const std::size_t i = at % 40;
      const std::size_t j = at / 40 % 40;
      const std::size_t k = at / 1600;
      if (j < 5 || j >= 30 || k < 5 || k >= 30) continue;
      if (i >= 5 && i < 20) voxels[at] = 7;
      if (i >= 20 && i < 30) voxels[at] = 9;
      if (i == 35) voxels[at] = 11;
    }
    put_bytes(folder_.path("labels.raw"), voxels);
    put_bytes(folder_.path("labels.mhd"), metaimage("40 40 40", "labels.raw"));
  }

  Outcome convert(const std::string& arguments) const {
    return folder_.run("slices-to-points " + arguments);
  }

  void expect_refused(const std::string& arguments, int exit_code, const std::string& says) const {
    SCOPED_TRACE(arguments);
    const auto before = folder_.names();
    const Outcome outcome = convert(arguments);
    EXPECT_EQ(outcome.exit_code, exit_code) << outcome.error;
    EXPECT_THAT(outcome.error, StartsWith("slices-to-points: "));
    EXPECT_THAT(outcome.error, HasSubstr(says));
    EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1) << outcome.error;
    EXPECT_EQ(folder_.names(), before) << "something was left behind";
  }

  CommandFolder folder_;
};

struct RealVolume {
  std::string name;
  std::string unpack;  ///< a command that makes what `arguments` name
  std::string arguments;
  int points;
};

std::vector<RealVolume> real_volumes() {
  return {
      {"engine", "", "DATA/volumes/engine_ct.nii.gz --above 100", 216519},
      {"brain", "", "DATA/volumes/allen_human_brain_labels.nii.gz --label any", 667824},
      {"abdomen", "", "DATA/volumes/abdominal_atlas_labels.nrrd --label any", 331131},
      {"frog skeleton", "", "DATA/volumes/frogtissue.mhd --label 13", 198422},
      {"head", "", "DATA/stacks/vhf_head_ct_png --spacing 1,1,1 --above 100", 206613},
      {"frog skeleton mask", "",
       "DATA/stacks/frog_masks_tiff/skeletonMasks.tiff --spacing 1,1,1.5 --label 1", 198340},
      {"chest", "tar --zstd -xf DATA/stacks/chest_ct_dicom.tar.zst",
       "chest_ct_dicom --at-least -400", 870006},
      {"chest bones", "tar --zstd -xf DATA/stacks/chest_ct_dicom.tar.zst",
       "chest_ct_dicom --at-least 200", 479434},
      {"raw slices", "tar -xzf DATA/stacks/ct_head_raw_slices.tar.gz",
       "ct_head_raw_slices/quarter.nhdr --above 1150", 21211},
  };
}

std::string with_data(std::string command) {
  for (std::size_t at; (at = command.find("DATA")) != std::string::npos;) {
    command.replace(at, 4, kData);
  }
  return command;
}

TEST_F(Converter, FindsEveryBoundaryVoxelOfRealVolumes) {
  if (!std::filesystem::exists(kData)) GTEST_SKIP() << "no sample data beside the project";
  for (const RealVolume& volume : real_volumes()) {
    SCOPED_TRACE(volume.name);
    if (!volume.unpack.empty()) {
      ASSERT_EQ(folder_.run(with_data(volume.unpack)).exit_code, 0);
    }
    const Outcome outcome =
        convert(with_data(volume.arguments) + " --boundary-voxels -o points.f32");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
    EXPECT_EQ(std::filesystem::file_size(folder_.path("points.f32")), 12U * volume.points);
    EXPECT_THAT(outcome.error, StartsWith("slices-to-points: " + std::to_string(volume.points) +
                                          " points: boundary voxels of "));
  }
}

TEST_F(Converter, HandsPointsAndTheirSpacingToTheReconstruction) {
  const Outcome outcome = folder_.run(
      "slices-to-points labels.mhd --label 7,9 --every 1,1,2 -o - 2>said | "
      "stream-recon - -o box.ply --report report.json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error << folder_.bytes("said");
  const nlohmann::json input = folder_.json("report.json").at("input");
  EXPECT_EQ(input.at("spacing"), nlohmann::json({0.5, 0.5, 3}));
  EXPECT_THAT(folder_.bytes("said"), HasSubstr(std::to_string(input.at("points").get<int>()) +
                                               " points: boundary of labels 7,9"));
}

TEST_F(Converter, WritesTheSamePointsInEveryFormat) {
  ASSERT_EQ(convert("labels.mhd --label 7 --scalar double -o p.f64").exit_code, 0);
  for (const std::string output :
       {"p.ply", "p.pts", "p.xyz", "- --output-format ply >q.ply", "- >q.pts"}) {
    SCOPED_TRACE(output);
    ASSERT_EQ(convert("labels.mhd --label 7 --scalar double -o " + output).exit_code, 0);
  }
  // A pts stream knows the spacing, which the solid would use.
  ASSERT_EQ(folder_.run("stream-recon p.f64 --surface gamma -o p.vtk").exit_code, 0);
  for (const std::string name : {"p.ply", "p.pts", "p.xyz", "q.ply", "q.pts"}) {
    SCOPED_TRACE(name);
    ASSERT_EQ(folder_.run("stream-recon " + name + " --surface gamma -o again.vtk").exit_code, 0);
    EXPECT_TRUE(folder_.bytes("again.vtk") == folder_.bytes("p.vtk"));
  }
}

TEST_F(Converter, OfEachLabelWritesAFileAndSaysWhichLabelsAreTooThin) {
  const Outcome outcome = convert("labels.mhd --label each -o organ.ply");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.error, HasSubstr("3 labels"));
  EXPECT_THAT(outcome.error, HasSubstr("smoothed away, they have no file: 11;"));
  EXPECT_TRUE(folder_.has("organ_7.ply"));
  EXPECT_TRUE(folder_.has("organ_9.ply"));
  EXPECT_FALSE(folder_.has("organ_11.ply"));
  EXPECT_EQ(convert("labels.mhd --label each --keep-thin -o organ.ply").exit_code, 0);
  EXPECT_TRUE(folder_.has("organ_11.ply"));
  ASSERT_EQ(convert("labels.mhd --label 7 -o seven.ply").exit_code, 0);
  EXPECT_EQ(convert("labels.mhd --label each -o organ.ply").exit_code, 0);
  EXPECT_TRUE(folder_.bytes("organ_7.ply") == folder_.bytes("seven.ply"));
}

TEST_F(Converter, RefusesInOneLine) {
  put_bytes(folder_.path("grey.raw"), std::string("\x01\x02", 2));
  put_bytes(folder_.path("grey.mhd"), metaimage("2 1 1", "grey.raw"));
  put_bytes(folder_.path("cut.mhd"), metaimage("2 2 1", "grey.raw"));
  put_bytes(folder_.path("offsets"), "0 1 1\n1 2\n");
  expect_refused("labels.mhd -o o.ply", 64, "--iso, --label, --above and --at-least");
  expect_refused("labels.mhd --iso 1 --label 7 -o o.ply", 64, "one of --iso");
  expect_refused("labels.mhd --iso 1", 64, "--output");
  expect_refused("labels.mhd --iso inf -o o.ply", 64, "finite");
  expect_refused("labels.mhd --iso 1 --boundary-voxels -o o.ply", 64, "--at-least");
  expect_refused("labels.mhd --label 7 --boundary-voxels --smooth 1 -o o.ply", 64, "--smooth");
  expect_refused("labels.mhd --label 7 --boundary-voxels --keep-thin -o o.ply", 64, "--keep-thin");
  expect_refused("labels.mhd --label 7, -o o.ply", 64, "--label 7,");
  expect_refused("labels.mhd --label seven -o o.ply", 64, "--label seven");
  expect_refused("labels.mhd --label each -o -", 64, "--label each");
  expect_refused("labels.mhd --label 7 --roi 1:2 -o o.ply", 64, "--roi");
  expect_refused("labels.mhd --label 7 --roi 1:2,:,60:70 -o o.ply", 64, "leaves the volume");
  expect_refused("labels.mhd --label 7 --every 0 -o o.ply", 64, "--every");
  expect_refused("labels.mhd --label 7 --every 1,2 -o o.ply", 64, "--every");
  expect_refused("labels.mhd --label 7 --spacing 1,1,0 -o o.ply", 64, "--spacing");
  expect_refused("labels.raw --type u8 --label 7 -o o.ply", 64, "--dims");
  expect_refused("labels.mhd --label 7 --align offsets -o o.ply", 65, "line 2");
  expect_refused("labels.mhd --label 7 --align missing -o o.ply", 74, "missing");
  expect_refused("labels.mhd --label 8 -o o.ply", 65, "labels here: 7, 9, 11");
  expect_refused("labels.mhd --label 11 -o o.ply", 65, "smoothed away");
  expect_refused("labels.mhd --iso 300 -o o.ply", 65, "hold 0 to 11");
  expect_refused("labels.mhd --label 7 -o missing/o.ply", 74, "missing/o.ply");
  expect_refused("labels.raw --dims 40,40,40 --label 7 -o o.ply", 65, "--spacing");
  expect_refused("labels.raw --dims 40,40,41 --spacing 1,1,1 --label 7 -o o.ply", 65, "labels.raw");
  expect_refused("cut.mhd --iso 1 -o o.ply", 65, "cut.mhd: ends within slices 0");
}

// Nothing of a result that did not come to its end, neither of the converter's nor of the run's.
TEST_F(Converter, KilledInAPipeLeavesNothing) {
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  ASSERT_EQ(convert("labels.mhd --label 7 -o whole.pts").exit_code, 0);
  const auto before = folder_.names();
  const std::size_t size = folder_.bytes("whole.pts").size();
  for (int round = 0; round < 10; ++round) {
    const std::size_t bytes = std::uniform_int_distribution<std::size_t>(0, size - 1)(random);
    const Outcome outcome =
        folder_.run("slices-to-points labels.mhd --label 7 -o - 2>/dev/null | head -c " +
                    std::to_string(bytes) + " | stream-recon - -o o.ply");
    EXPECT_EQ(outcome.exit_code, 65) << outcome.error;
    EXPECT_EQ(folder_.names(), before);
  }
  const Outcome closed = folder_.run(
      "{ slices-to-points labels.mhd --label 7 -o - --scalar double; echo $? >code; } | true");
  EXPECT_THAT(folder_.bytes("code"), testing::AnyOf("74\n", "0\n"));
}

std::size_t peak_kilobytes(const CommandFolder& folder, const std::string& command) {
  const Outcome outcome = folder.run(
      "python3 -c 'import resource, subprocess, sys; subprocess.check_call(sys.argv[1:]); "
      "print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)' " +
      command);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
  return std::stoul(outcome.out);
}

// 2,000 slices of 256 x 256 in a packed NIfTI, whose voxels are 131 MB.
TEST_F(Converter, TakesNoMoreMemoryForALongStack) {
  const auto write_stack = [&](const std::string& name, std::int16_t slices) {
    std::string header(352, '\0');
    const auto put = [&](std::size_t at, auto value) {
      std::memcpy(&header[at], &value, sizeof value);
    };
    put(0, std::int32_t{348});
    for (int d = 0; const std::int16_t n : {std::int16_t{3}, std::int16_t{256}, std::int16_t{256},
                                            slices, std::int16_t{1}}) {
      put(40 + 2 * d++, n);
    }
    put(70, std::int16_t{2});  // unsigned char
    put(72, std::int16_t{8});
    for (int d = 0; d < 4; ++d) put(76 + 4 * d, 1.0F);
    put(108, 352.0F);
    std::memcpy(&header[344], "n+1", 4);
    gzFile file = gzopen(folder_.path(name).c_str(), "wb1");
    gzwrite(file, header.data(), static_cast<unsigned>(header.size()));
    std::string slice(256 * 256, '\0');
    for (int j = 60; j < 200; ++j) std::fill_n(&slice[j * 256 + 50], 150, '\x01');
    for (int k = 0; k < slices; ++k) gzwrite(file, slice.data(), 256 * 256);
    gzclose(file);
  };
  write_stack("short.nii.gz", 2);
  write_stack("long.nii.gz", 2000);
  const std::string options = " --label 1 -o points.f32";
  const std::size_t few =
      peak_kilobytes(folder_, "slices-to-points short.nii.gz --keep-thin" + options);
  const std::size_t many = peak_kilobytes(folder_, "slices-to-points long.nii.gz" + options);
  EXPECT_LE(many, few + 64 * 1024);
  EXPECT_GE(std::filesystem::file_size(folder_.path("points.f32")), 12U * 2000 * 500);
}

}  // namespace
}  // namespace stream_recon
