// The programs as a user calls them: exit codes, one line of reason, nothing left half done.

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>

#include "tests/io_test_folder.h"

namespace stream_recon {
namespace {

class Programs : public testing::Test {
 protected:
  struct Result {
    int code;
    std::string output;
    std::string error;
  };

  Result run(const std::string& command) const {
    const std::string line = "cd '" + folder_.path() +
                             "' && PATH='" STREAM_RECON_BIN "':\"$PATH\" && " + command +
                             " > stdout.log 2> stderr.log";
    const int status = std::system(line.c_str());
    return {WEXITSTATUS(status), file_bytes(folder_ / "stdout.log"),
            file_bytes(folder_ / "stderr.log")};
  }

  void expect_refusal(const std::string& command, int code) const {
    SCOPED_TRACE(command);
    const Result result = run(command);
    EXPECT_EQ(result.code, code);
    EXPECT_EQ(std::count(result.error.begin(), result.error.end(), '\n'), 1) << result.error;
    EXPECT_TRUE(result.error.starts_with(command.substr(0, command.find(' ')) + ": "))
        << result.error;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
  }

  TestFolder folder_;
};

TEST_F(Programs, HelpIsNoError) {
  for (const char* program : {"make-cloud", "bench-kernel", "mesh-preview"}) {
    const Result result = run(std::string(program) + " --help");
    EXPECT_EQ(result.code, 0) << program;
    EXPECT_NE(result.output.find("Usage"), std::string::npos) << program;
  }
}

TEST_F(Programs, WrongUseIs64) {
  expect_refusal("make-cloud cube", 64);
  expect_refusal("make-cloud cubes -o out", 64);
  expect_refusal("make-cloud cube -n many -o out", 64);
  expect_refusal("make-cloud cube --format stl -o out", 64);
  expect_refusal("make-cloud shell --slice-step 0 -o out", 64);
  expect_refusal("make-cloud sphere --sampling corners -o out", 64);
  expect_refusal("make-cloud cube --sampling faces -o out", 64);
  expect_refusal("make-cloud sphere --sampling noisy --noise 11 -o out", 64);
  expect_refusal("make-cloud plate --width 2 -o out", 64);
  expect_refusal("bench-kernel", 64);
  expect_refusal("bench-kernel a b", 64);
  expect_refusal("bench-kernel a --threads 0", 64);
  expect_refusal("mesh-preview a.pvtp", 64);
  expect_refusal("mesh-preview a.pvtp -o out --size 10", 64);
  expect_refusal("mesh-preview a.pvtp -o out --view inside", 64);
  expect_refusal("mesh-preview a.pvtp -o out --views front,inside", 64);
  expect_refusal("mesh-preview a.pvtp -o out --color pink", 64);
  expect_refusal("mesh-preview a.pvtp b.pvtp c.pvtp -o out --color none --color none", 64);
  expect_refusal("mesh-preview a.pvtp -o out --background pink", 64);
  expect_refusal("mesh-preview a.pvtp -o out --view left --views front,top", 64);
}

TEST_F(Programs, BadInputIs65) {
  put_bytes(folder_ / "bad.ply", "ply\nformat binary_little_endian 1.0\nelement vertex 9\n");
  put_bytes(folder_ / "bad.pvtp", "<VTKFile");
  put_bytes(folder_ / "nan.xyz", "0 0 0\n1 nan 0\n");
  expect_refusal("bench-kernel bad.ply", 65);
  expect_refusal("bench-kernel nan.xyz", 65);
  expect_refusal("mesh-preview bad.pvtp -o out", 65);
}

TEST_F(Programs, WhatTheSystemRefusesIs74) {
  expect_refusal("make-cloud cube -n 10 -o missing/out", 74);
  expect_refusal("make-cloud cube -n 10 -o /dev/full", 74);
  expect_refusal("bench-kernel missing.ply", 74);
  expect_refusal("mesh-preview missing.pvtp -o out", 74);
  EXPECT_EQ(run("sh -c 'make-cloud cube -n 100000 -o - > /dev/full'").code, 74);
}

TEST_F(Programs, ACloudGoesThroughAPipeIntoTheKernel) {
  const Result piped = run("make-cloud cube -n 2000 --seed 4 -o - | bench-kernel - --json");
  EXPECT_EQ(piped.code, 0) << piped.error;
  EXPECT_EQ(run("make-cloud cube -n 2000 --seed 4 -o cube.xyz").code, 0);
  const Result read = run("bench-kernel cube.xyz --json");
  const auto digest = [](const std::string& json) { return json.substr(json.find("digest"), 28); };
  EXPECT_EQ(digest(piped.output), digest(read.output));
  EXPECT_NE(read.output.find("\"points\": 2000"), std::string::npos) << read.output;
}

TEST_F(Programs, SamplesOfASolidTellTheirPixel) {
  const Result faces = run("make-cloud torus --sampling faces --slice-step 2 -n 3000 -o a.pts");
  EXPECT_EQ(faces.code, 0) << faces.error;
  EXPECT_EQ(run("make-cloud torus --sampling faces --slice-step 2 -n 3000 -o b.pts").code, 0);
  EXPECT_EQ(file_bytes(folder_ / "a.pts"), file_bytes(folder_ / "b.pts"));
  EXPECT_NE(file_bytes(folder_ / "a.pts").find("\"spacing\""), std::string::npos);
}

TEST_F(Programs, DuplicatesAndFlatCloudsAreTimedToo) {
  put_bytes(folder_ / "flat.xyz", "0 0 0\n1 0 0\n0 1 0\n1 0 0\n1 1 0\n");
  const Result flat = run("bench-kernel flat.xyz --json");
  EXPECT_EQ(flat.code, 0) << flat.error;
  EXPECT_NE(flat.output.find("\"points\": 4"), std::string::npos) << flat.output;
  EXPECT_NE(flat.output.find("\"duplicates\": 1"), std::string::npos);
  EXPECT_NE(flat.output.find("\"dimension\": 2"), std::string::npos);
  EXPECT_NE(flat.output.find("\"tetrahedra\": 0"), std::string::npos);
  EXPECT_EQ(run("make-cloud cube -n 0 -o none.ply && bench-kernel none.ply").code, 0);
}

TEST_F(Programs, PolesAreTimedInPlaceOfPoints) {
  EXPECT_EQ(run("make-cloud cube -n 2000 --seed 4 -o cube.xyz").code, 0);
  const Result poles = run("bench-kernel cube.xyz --poles --json");
  EXPECT_EQ(poles.code, 0) << poles.error;
  EXPECT_NE(poles.output.find("\"hidden\": 0"), std::string::npos) << poles.output;
  EXPECT_EQ(poles.output.find("\"points\": 2000,"), std::string::npos);
  EXPECT_EQ(poles.output.find("\"tetrahedra\": 0"), std::string::npos);
  put_bytes(folder_ / "flat.xyz", "0 0 0\n1 0 0\n0 1 0\n1 1 0\n");
  const Result flat = run("bench-kernel flat.xyz --poles --json");
  EXPECT_EQ(flat.code, 0) << flat.error;
  EXPECT_NE(flat.output.find("\"points\": 0"), std::string::npos) << flat.output;
}

#ifdef STREAM_RECON_HAS_CONVERTERS
TEST_F(Programs, SlicesToPointsFollowsTheSameRules) {
  put_bytes(folder_ / "ramp.mhd",
            "ObjectType = Image\nNDims = 3\nDimSize = 2 1 1\nElementSpacing = 2 1 1\n"
            "Offset = 10 20 30\nElementType = MET_UCHAR\nElementDataFile = ramp.raw\n");
  put_bytes(folder_ / "ramp.raw", std::string("\x00\x04", 2));
  const Result points = run("slices-to-points ramp.mhd --iso 1 -o - --output-format xyz");
  EXPECT_EQ(points.code, 0) << points.error;
  EXPECT_EQ(points.output, "10.5 20 30\n");
  const Result ply = run("slices-to-points ramp.mhd --iso 1 -o - --output-format ply");
  EXPECT_NE(ply.output.find("element vertex 1\nproperty float x"), std::string::npos);

  expect_refusal("slices-to-points ramp.mhd -o out", 64);
  expect_refusal("slices-to-points ramp.mhd --iso nan -o out", 64);
  expect_refusal("slices-to-points missing.nii --iso 1 -o out", 65);
  put_bytes(folder_ / "ramp.raw", std::string("\x00", 1));
  expect_refusal("slices-to-points ramp.mhd --iso 1 -o out", 65);
  expect_refusal("slices-to-points . --iso 1 -o out", 65);
}
#endif

}  // namespace
}  // namespace stream_recon
