// Which format an input is, and inputs that cannot be opened at all.
#include <gtest/gtest.h>

#include "io/byte_source.h"
#include "io_reader_helpers.h"

namespace stream_recon {
namespace {

using ::testing::Test;

std::string io_error_of(const std::string& path) {
  try {
    open_point_source(path, InputFormat::kAuto);
  } catch (const IoError& error) {
    return error.what();
  }
  return "none";
}

TEST(OpenInput, NamesWhatTheSystemRefuses) {
  const TestFolder folder;
  EXPECT_NE(io_error_of(folder / "missing").find("No such file"), std::string::npos);
  EXPECT_NE(io_error_of(folder.path()).find("it is a directory"), std::string::npos);
  put_bytes(folder / "file", "1 2 3\n");
  EXPECT_NE(io_error_of(folder / "file/below").find("Not a directory"), std::string::npos);
}

TEST(OpenInput, SaysHowToReadCompressedFiles) {
  const ByteFile file;
  const Outcome zstd = file.read("\x28\xB5\x2F\xFD rest", InputFormat::kAuto);
  EXPECT_NE(zstd.error.find("zstd -dc"), std::string::npos) << zstd.error;
  const Outcome gzip = file.read("\x1F\x8B\x08 rest", InputFormat::kPly);
  EXPECT_NE(gzip.error.find("gzip -dc"), std::string::npos) << gzip.error;
}

TEST(OpenInput, RefusesWhatItDoesNotKnow) {
  const ByteFile file;
  EXPECT_NE(file.read("", InputFormat::kAuto).error.find("empty"), std::string::npos);
  EXPECT_NE(file.read(std::string("\0\1\2\3", 4), InputFormat::kAuto).error.find("--input-format"),
            std::string::npos);
  EXPECT_NE(file.read("ply but no header", InputFormat::kAuto).error, "");
  EXPECT_NE(file.read("<html>", InputFormat::kVtp).error.find("XML"), std::string::npos);
  EXPECT_NE(file.read("1 2 3\n", InputFormat::kPly).error.find("not a PLY file"),
            std::string::npos);
  EXPECT_NE(file.read("1 2 3\n", InputFormat::kVtk).error.find("not a legacy VTK file"),
            std::string::npos);
}

TEST(OpenInput, KnowsRawNumbersByTheirEnding) {
  const TestFolder folder;
  const std::array<double, 6> values{1, 2, 3, 4, 5, 6};
  put_bytes(folder / "a.f32", packed<float>(values, false));
  put_bytes(folder / "a.f64", packed<double>(values, false));
  const std::vector<Point3> expected{{1, 2, 3}, {4, 5, 6}};
  EXPECT_EQ(read_path(folder / "a.f32", InputFormat::kAuto).points, expected);
  EXPECT_EQ(read_path(folder / "a.f64", InputFormat::kAuto).points, expected);
}

TEST(OpenInput, RefusesRawFilesOfAnotherSizeAtOnce) {
  const ByteFile file;
  const Outcome outcome = file.read(std::string(25, 'a'), InputFormat::kF32);
  EXPECT_TRUE(outcome.points.empty());
  EXPECT_NE(outcome.error.find("byte 24:"), std::string::npos) << outcome.error;
}

TEST(OpenInput, RefusesRawPipesThatEndInsideAPoint) {
  const FedPipe pipe(std::string(25, 'a'), 7);
  const Outcome outcome = read_path(pipe.path(), InputFormat::kF32);
  EXPECT_NE(outcome.error.find("byte 24:"), std::string::npos) << outcome.error;
}

TEST(OpenInput, ReadsStandardInput) {
  const FedPipe pipe("1 2 3\n4 5 6\n", 3);
  const int saved = ::dup(STDIN_FILENO);
  ::dup2(pipe.descriptor(), STDIN_FILENO);
  const Outcome outcome = read_path("-", InputFormat::kAuto);
  ::dup2(saved, STDIN_FILENO);
  ::close(saved);
  EXPECT_EQ(outcome.points, (std::vector<Point3>{{1, 2, 3}, {4, 5, 6}}));
}

TEST(PlyFile, WithMoreBytesThanItsHeaderTellsIsRefused) {
  const ByteFile file;
  const std::string properties = "property float x\nproperty float y\nproperty float z\n";
  const auto ply = [&](const char* format, const std::string& more, const std::string& body) {
    return std::string("ply\nformat ") + format + " 1.0\nelement vertex 1\n" + properties + more +
           "end_header\n" + body;
  };
  const std::string faces = "element face 1\nproperty list uchar int vertex_indices\n";
  EXPECT_NE(file.read(ply("ascii", "", "1 2 3\n4 5 6\n"), InputFormat::kPly).error, "");
  EXPECT_NE(file.read(ply("ascii", "", "1 2 3 4\n"), InputFormat::kPly).error, "");
  EXPECT_EQ(file.read(ply("ascii", faces, "1 2 3\n3 0"), InputFormat::kPly).error, "");
  EXPECT_EQ(file.read(ply("ascii", "", "1 2 3\n \n\n"), InputFormat::kPly).error, "");
  const char* binary = "binary_little_endian";
  const std::string point(12, '\x01');
  EXPECT_NE(file.read(ply(binary, "", point + "a"), InputFormat::kPly).error, "");
  EXPECT_EQ(file.read(ply(binary, faces, point + "a"), InputFormat::kPly).error, "");
  EXPECT_EQ(file.read(ply(binary, "", point + "\n"), InputFormat::kPly).error, "");
}

TEST(PlyFile, WithoutUsableCoordinatesIsRefused) {
  const ByteFile file;
  for (const char* properties :
       {"property float x\nproperty float y\n", "property float x\nproperty list uchar float y\n",
        "property float x\nproperty int64 y\nproperty float z\n",
        "property float x\nproperty float y\nproperty float z\nproperty float x\n"}) {
    const Outcome outcome = file.read(std::string("ply\nformat ascii 1.0\nelement vertex 1\n") +
                                          properties + "end_header\n1 2 3 4\n",
                                      InputFormat::kPly);
    EXPECT_NE(outcome.error.find("line "), std::string::npos) << properties;
  }
  EXPECT_NE(file.read("ply\nformat ascii 1.0\nend_header\n", InputFormat::kPly).error, "");
}

TEST(PlyFile, WithAnEndlessHeaderIsRefused) {
  const ByteFile file;
  std::string header = "ply\nformat ascii 1.0\n";
  while (header.size() < 3 << 20) header += "comment " + std::string(100, 'c') + "\n";
  EXPECT_NE(file.read(header, InputFormat::kPly).error.find("no end_header"), std::string::npos);
}

TEST(LegacyVtkFile, WithoutPointsOfItsOwnIsRefused) {
  const ByteFile file;
  for (const char* kind : {"STRUCTURED_POINTS", "RECTILINEAR_GRID", "FIELD"}) {
    const Outcome outcome =
        file.read(std::string("# vtk DataFile Version 3.0\nx\nASCII\nDATASET ") + kind + "\n",
                  InputFormat::kAuto);
    EXPECT_NE(outcome.error.find("no list of points"), std::string::npos) << outcome.error;
  }
}

TEST(LegacyVtkFile, WithMorePointsThanItTellsIsRefused) {
  const ByteFile file;
  const std::string head = "# vtk DataFile Version 3.0\nx\n";
  const std::string points = "\nDATASET POLYDATA\nPOINTS 1 float\n";
  EXPECT_NE(file.read(head + "ASCII" + points + "1 2 3 4 5 6\n", InputFormat::kVtk).error, "");
  EXPECT_NE(file.read(head + "BINARY" + points + std::string(24, '\1'), InputFormat::kVtk).error,
            "");
  EXPECT_EQ(file.read(head + "ASCII" + points + "1 2 3\nCELL_DATA 1", InputFormat::kVtk).error, "");
}

TEST(RealCloud, IsReadWhole) {
  const std::string path = std::string(STREAM_RECON_SHARED_DATA) + "/clouds/bunny.ply";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
  const Outcome outcome = read_path(path, InputFormat::kAuto);
  EXPECT_EQ(outcome.error, "");
  EXPECT_EQ(outcome.points.size(), 35947U);
  EXPECT_EQ(outcome.points.back(), (Point3{-0.0400442F, 0.15362F, -0.00816685F}));
}

}  // namespace
}  // namespace stream_recon
