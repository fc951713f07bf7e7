// What VTK's own writers write is what we read, in every mode they have.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>

#include "io/vtp_mesh_reader.h"
#include "io_reader_helpers.h"

namespace stream_recon {
namespace {

constexpr std::size_t kCount = 3000;

/// The cloud of io_reader_vtk_writer.py: few digits, so that short texts hold it exactly.
std::vector<Point3> cloud() {
  std::vector<Point3> points;
  for (std::size_t i = 0; i < kCount; ++i) {
    points.push_back({static_cast<double>(i * 7919 % 1000) / 8,
                      -static_cast<double>(i * 104729 % 997) / 4, static_cast<double>(i)});
  }
  return points;
}

class VtkWritten : public ::testing::Test {
 protected:
  void SetUp() override {
    const std::string command = std::string("/usr/bin/python3 ") + STREAM_RECON_TESTS +
                                "/io_reader_vtk_writer.py " + folder_.path();
    const int status = std::system(command.c_str());
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    if (code == 77 || code == 127) {
      GTEST_SKIP() << "no VTK for /usr/bin/python3 (package python3-vtk9)";
    }
    ASSERT_EQ(code, 0) << command;
  }
  TestFolder folder_;
};

TEST_F(VtkWritten, FilesGiveTheSamePointsAndSurfaces) {
  const std::vector<Point3> expected = cloud();
  std::size_t surfaces = 0;
  const std::vector<std::string> names = folder_.names();
  EXPECT_EQ(names.size(), 2 * (12 + 48) + 1U);
  for (const std::string& name : names) {
    SCOPED_TRACE(name);
    const Outcome outcome = read_path(folder_ / name, InputFormat::kAuto);
    if (name.starts_with("refused")) {
      EXPECT_NE(outcome.error.find("vtkLZMADataCompressor"), std::string::npos) << outcome.error;
      continue;
    }
    EXPECT_EQ(outcome.error, "");
    EXPECT_EQ(outcome.points, expected);
    if (!name.ends_with(".vtp")) continue;
    const VtpMesh mesh = read_vtp_mesh(folder_ / name);
    EXPECT_EQ(mesh.points, expected);
    ASSERT_EQ(mesh.triangles.size(), kCount - 2);
    EXPECT_EQ(mesh.triangles[7], (std::array<std::uint32_t, 3>{7, 8, 9}));
    ASSERT_EQ(mesh.delta.size(), kCount - 2);
    EXPECT_EQ(mesh.delta[33], 33.0F / 32);
    ASSERT_EQ(mesh.source.size(), kCount - 2);
    EXPECT_EQ(mesh.source[33], 1);
    ASSERT_EQ(mesh.global_ids.size(), kCount);
    EXPECT_EQ(mesh.global_ids[33], 99U);
    ++surfaces;
  }
  EXPECT_EQ(surfaces, 48U);
}

}  // namespace
}  // namespace stream_recon
