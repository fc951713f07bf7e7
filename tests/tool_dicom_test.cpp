// DICOM series: which slices, in which order, where; and everything that must be refused.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/io_test_folder.h"
#include "tests/small_dicom.h"
#include "tests/volume_check.h"

namespace stream_recon {
namespace {

class Dicom : public testing::Test {
 protected:
  void put(const std::string& name, const SmallDicom& file) const {
    put_bytes(folder_ / name, bytes_of(file));
  }
  /// Slices 1 to `count` at the heights 10, 12.5, 15, ... under names in another order.
  void put_series(int count, const std::string& prefix = "s", const std::string& uid = "1.2.3.1") {
    for (int n = 1; n <= count; ++n) {
      SmallDicom file;
      file.series = uid;
      file.number = n;
      file.position = "-4\\6\\" + std::to_string(7.5 + 2.5 * n);
      put(prefix + std::to_string(n * 7 % 11 + 10) + ".dcm", file);
    }
  }
  std::string refused() const { return refusal(folder_.path()); }
  std::unique_ptr<Volume> open(const std::string& series = "") const {
    VolumeRequest request = request_of({folder_.path()}, true);
    request.series = series;
    return open_volume(request);
  }

  TestFolder folder_;
};

/// A place above the origin.
std::string at_height(const std::string& z) {
  return std::string("0\\0\\").append(z);
}

void expect_says(const std::string& message, const std::string& part) {
  EXPECT_NE(message.find(part), std::string::npos) << "'" << message << "' lacks '" << part << "'";
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

TEST_F(Dicom, SlicesAreSortedByTheirPlaceWhateverTheirNames) {
  put_series(5);
  const auto volume = open();
  EXPECT_EQ(volume->geometry().size, (std::array<std::size_t, 3>{3, 2, 5}));
  EXPECT_EQ(volume->geometry().position(0, 0, 0), (Point3{-4, 6, 10}));
  EXPECT_EQ(volume->geometry().position(2, 1, 4), (Point3{-3.5, 6.5, 20}));
  std::vector<double> expected;
  for (int n = 1; n <= 5; ++n)
    for (int i = 0; i < 6; ++i) expected.push_back(100 * n + i);
  EXPECT_EQ(voxels_of(*volume), expected);
  EXPECT_EQ(voxels_of(*volume), expected) << "in a second scan";
}

// A coronal series: the normal of row x column points to -y.
TEST_F(Dicom, GeometryFollowsTheOrientationAndIsThatOfItk) {
  for (int n = 1; n <= 4; ++n) {
    SmallDicom file;
    file.number = n;
    file.orientation = "1\\0\\0\\0\\0\\1";
    file.position = "1\\" + std::to_string(3 * n) + "\\2";
    put("c" + std::to_string(n), file);
  }
  const auto volume = open();
  EXPECT_EQ(volume->geometry().position(0, 0, 0), (Point3{1, 12, 2}));
  EXPECT_EQ(volume->geometry().position(4, 2, 1), (Point3{2, 9, 3}));
  const auto image = read_with_itk(folder_ / "c4");
  itk::Image<double, 3>::PointType point;
  image->TransformIndexToPhysicalPoint({{4, 2, 0}}, point);
  const Point3 p = volume->geometry().position(4, 2, 0);
  EXPECT_EQ(p, (Point3{point[0], point[1], point[2]}));
}

TEST_F(Dicom, ATiltedGantryShiftsTheSlices) {
  for (int n = 1; n <= 4; ++n) {
    SmallDicom file;
    file.number = n;
    file.position = "0\\" + std::to_string(0.5 * n) + "\\" + std::to_string(2 * n);
    put("t" + std::to_string(n), file);
  }
  EXPECT_EQ(open()->geometry().position(0, 0, 2), (Point3{0, 1.5, 6}));
}

TEST_F(Dicom, EachSliceIsRescaledAsItsHeaderSays) {
  for (int n = 1; n <= 2; ++n) {
    SmallDicom file;
    file.number = n;
    file.position = at_height(std::to_string(n));
    file.slope = n == 1 ? "2" : "0.5";
    file.intercept = "-1000";
    file.voxels = {0, 1, -7, 900, 2, 3};
    put("r" + std::to_string(n), file);
  }
  EXPECT_EQ(voxels_of(*open()), (std::vector<double>{-1000, -998, -1014, 800, -996, -994, -1000,
                                                     -999.5, -1003.5, -550, -999, -998.5}));
}

TEST_F(Dicom, OtherFilesInTheFolderArePassedOver) {
  put_series(3);
  put_bytes(folder_ / "README.txt", "text");
  put_bytes(folder_ / ".hidden.dcm", "nothing");
  put_bytes(folder_ / "preview.jpg", "no DICOM");
  SmallDicom report;
  report.has_image = false;
  report.series = "1.2.3.9";
  put("report.dcm", report);
  EXPECT_EQ(open()->geometry().size[2], 3U);
}

TEST_F(Dicom, FilesGivenOneByOneAreSortedToo) {
  put_series(3);
  std::vector<std::string> paths;
  for (const std::string& name : folder_.names()) paths.push_back(folder_ / name);
  std::reverse(paths.begin(), paths.end());
  const auto volume = open_volume(request_of(paths, true));
  EXPECT_EQ(volume->geometry().origin.z, 10);
  EXPECT_EQ(volume->geometry().step[2], (Point3{0, 0, 2.5}));
}

TEST_F(Dicom, OfSeveralSeriesOneMustBeChosen) {
  put_series(3, "a", "1.2.3.10");
  put_series(4, "b", "1.2.3.20");
  expect_says(refused(),
              "2 series, choose one with --series: 1: 1.2.3.10 \"Thorax\" 3 slices; "
              "2: 1.2.3.20 \"Thorax\" 4 slices");
  EXPECT_EQ(open("1.2.3.10")->geometry().size[2], 3U);
  EXPECT_EQ(open(".20")->geometry().size[2], 4U);
  EXPECT_EQ(open("2")->geometry().size[2], 4U);
  VolumeRequest request = request_of({folder_.path()});
  request.series = "1.9";
  expect_says(refusal(request), "--series 1.9 fits none of the series; there are 1: 1.2.3.10");
  request.series = "0";
  expect_says(refusal(request), "--series 0 fits several");
}

TEST_F(Dicom, ASeriesOfWhatIsNoDicomIsRefused) {
  put_bytes(folder_ / "a.mha",
            "ObjectType = Image\nNDims = 3\nDimSize = 1 1 1\nElementType = MET_CHAR\n"
            "BinaryData = True\nElementDataFile = LOCAL\nx");
  VolumeRequest request = request_of({folder_ / "a.mha"});
  request.series = "1";
  expect_says(refusal(request), "not DICOM, so it has no series");
}

TEST_F(Dicom, AMissingSliceIsRefusedWithNumbers) {
  put_series(6);
  std::filesystem::remove(folder_ / ("s" + std::to_string(3 * 7 % 11 + 10) + ".dcm"));
  expect_says(refused(), "5.000 mm behind ");
  expect_says(refused(), "but slices are 2.500 mm apart; a slice is missing between them");
}

TEST_F(Dicom, UnevenSlicesAreRefusedBeyondAFewPercent) {
  for (const auto& [last, is_even] : {std::pair{"3.02", true}, {"3.2", false}}) {
    for (int n = 0; n < 4; ++n) {
      SmallDicom file;
      file.number = n;
      file.position = at_height(n == 3 ? last : std::to_string(n));
      put(std::string("u").append(std::to_string(n)), file);
    }
    if (is_even) {
      EXPECT_EQ(refused(), "");
    } else {
      expect_says(refused(), "1.200 mm behind ");
      expect_says(refused(), "resample the series evenly");
    }
  }
}

TEST_F(Dicom, TwoSlicesAtOnePlaceAreRefused) {
  put_series(3);
  SmallDicom again;
  again.number = 9;
  again.position = "-4\\6\\12.5";
  put("z.dcm", again);
  expect_says(refused(), "at the place of ");
  expect_says(refused(), "(12.500 mm along the normal)");
}

TEST_F(Dicom, SlicesThatDifferAreRefusedByName) {
  SmallDicom odd;
  odd.number = 9;
  odd.position = "-4\\6\\17.5";
  const auto expect_refused = [&](const SmallDicom& file, const std::string& part) {
    put_series(3);
    put("z.dcm", file);
    expect_says(refused(), "z.dcm");
    expect_says(refused(), part);
  };
  SmallDicom file = odd;
  file.columns = 4;
  expect_refused(file, "4 x 2 voxels, but ");
  file = odd;
  file.orientation = "0\\1\\0\\1\\0\\0";
  expect_refused(file, "another orientation");
  file = odd;
  file.pixel_spacing = "0.5\\0.26";
  expect_refused(file, "another spacing");
  file = odd;
  file.position.reset();
  expect_refused(file, "no ImagePositionPatient");
  file = odd;
  file.frames = 2;
  expect_refused(file, "2 frames");
  file = odd;
  file.position = "-4\\16\\17.5";
  expect_refused(file, "not in a straight row");
}

TEST_F(Dicom, WithoutPixelSpacingItIsUnknown) {
  for (int n = 1; n <= 2; ++n) {
    SmallDicom file;
    file.number = n;
    file.position = at_height(std::to_string(n));
    file.pixel_spacing.reset();
    put("p" + std::to_string(n), file);
  }
  EXPECT_FALSE(open_volume(request_of({folder_.path()}))->geometry().has_spacing);
  expect_says(refusal(request_of({folder_.path()}, true)), "--spacing");
  std::filesystem::remove(folder_ / "p2");
  EXPECT_FALSE(open_volume(request_of({folder_ / "p1"}))->geometry().has_spacing);
}

TEST_F(Dicom, AFileOfItsOwnIsAVolume) {
  SmallDicom file;
  put("one.dcm", file);
  const auto one = open_volume(request_of({folder_ / "one.dcm"}, true));
  EXPECT_EQ(one->geometry().size, (std::array<std::size_t, 3>{3, 2, 1}));
  EXPECT_EQ(one->geometry().step[0].x, 0.25);
  EXPECT_EQ(voxels_of(*one), (std::vector<double>{100, 101, 102, 103, 104, 105}));
  file.frames = 4;
  put("four.dcm", file);
  const auto four = open_volume(request_of({folder_ / "four.dcm"}));
  EXPECT_EQ(four->geometry().size, (std::array<std::size_t, 3>{3, 2, 4}));
  EXPECT_EQ(voxels_of(*four)[23], 123);
}

TEST_F(Dicom, EveryTruncationIsRefusedWithOneLine) {
  put_series(3);
  const std::string last = "s" + std::to_string(3 * 7 % 11 + 10) + ".dcm";
  const std::string whole = file_bytes(folder_ / last);
  for (std::size_t left = 0; left < whole.size(); ++left) {
    put_bytes(folder_ / last, whole.substr(0, left));
    const std::string message = refused();
    ASSERT_NE(message.find(last), std::string::npos)
        << "cut to " << left << " of " << whole.size() << ": " << message;
    ASSERT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

TEST_F(Dicom, ASingleFileIsRefusedCutAtEveryByte) {
  SmallDicom file;
  const std::string whole = bytes_of(file);
  for (std::size_t left = 0; left < whole.size(); ++left) {
    put_bytes(folder_ / "a.dcm", whole.substr(0, left));
    const std::string message = refusal(folder_ / "a.dcm");
    ASSERT_NE(message, "") << "cut to " << left << " of " << whole.size();
    ASSERT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

TEST_F(Dicom, NothingIsPrintedAboutDamage) {
  const std::string whole = bytes_of({});
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  for (const std::size_t at : {std::size_t{140}, std::size_t{200}, whole.size() - 30}) {
    std::string bytes = whole;
    bytes.replace(at, 4, "\xff\xff\xff\xff");
    put_bytes(folder_ / "a.dcm", bytes);
    refusal(folder_ / "a.dcm");
  }
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(Dicom, DamageIsReadOrRefused) {
  std::mt19937 random(5);
  const std::string whole = bytes_of({});
  for (int round = 0; round < 30; ++round) {
    std::string bytes = whole;
    for (int n = 0; n < 3; ++n)
      bytes[128 + random() % (bytes.size() - 128)] = static_cast<char>(random());
    put_bytes(folder_ / "a.dcm", bytes);
    const std::string message = refusal(folder_ / "a.dcm");
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace stream_recon
