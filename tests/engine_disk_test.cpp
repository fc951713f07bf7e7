// What a run says about the disk before its long work, against what it then takes.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "engine/disk_estimate.h"
#include "engine/order/ingest.h"
#include "engine/reconstruct.h"
#include "io/folder.h"
#include "tests/io_test_folder.h"
#include "tests/point_families.h"

namespace stream_recon {
namespace {

using testing::HasSubstr;

constexpr std::uint64_t kPoints = 30000;

/// Random in every digit: what compresses worst.
void write_cloud(const TestFolder& folder) {
  std::mt19937_64 random(9);
  std::string bytes;
  for (std::uint64_t i = 0; i < kPoints; ++i) {
    const Point3 p = families::random_point(random);
    bytes.append(reinterpret_cast<const char*>(&p), sizeof p);
  }
  put_bytes(folder / "cloud.f64", bytes);
}

/// A bumpy ball, random in every digit.
std::string bumpy_ball(std::uint64_t points) {
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal;
  std::string bytes;
  for (std::uint64_t i = 0; i < points; ++i) {
    Point3 p{normal(random), normal(random), normal(random)};
    const double length = std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z);
    const double radius = 1 + 0.2 * std::sin(5 * p.x / length) * std::cos(4 * p.y / length);
    for (double* c : {&p.x, &p.y, &p.z}) *c *= radius / length;
    bytes.append(reinterpret_cast<const char*>(&p), sizeof p);
  }
  return bytes;
}

RunOptions options_in(const TestFolder& folder) {
  RunOptions options;
  options.inputs = {folder / "cloud.f64"};
  options.output = folder / "out.pvtp";
  options.tetrahedra = folder / "t.pvtu";
  return options;
}

std::uint64_t bytes_in(const std::string& folder) {
  std::uint64_t bytes = 0;
  for (const std::string& name : list_folder(folder))
    bytes += file_bytes(folder + "/" + name).size();
  return bytes;
}

TEST(DiskEstimate, IsAboveWhatIsTakenAndNotThreeTimesAsMuch) {
  const TestFolder folder;
  write_cloud(folder);
  const RunOptions options = options_in(folder);
  const DiskEstimate estimate = estimate_disk(kPoints, options);
  const Report report = reconstruct(options);
  EXPECT_GE(estimate.scratch, report.scratch_peak_bytes);
  EXPECT_LE(estimate.scratch, 3 * report.scratch_peak_bytes);
  const std::uint64_t outputs = bytes_in(folder / "out") + bytes_in(folder / "t");
  EXPECT_GE(estimate.outputs, outputs);
  EXPECT_LE(estimate.outputs, 3 * outputs);
}

TEST(DiskEstimate, CountsTheMedialAxis) {
  const TestFolder folder;
  write_cloud(folder);
  RunOptions options = options_in(folder);
  options.surface = SurfaceKind::kNone;
  options.tetrahedra = "";
  const DiskEstimate without = estimate_disk(kPoints, options);
  options.medial_axis = folder / "m.pvtp";
  options.medial_axis_side = PoleSide::kBoth;
  const DiskEstimate estimate = estimate_disk(kPoints, options);
  EXPECT_GT(estimate.scratch, without.scratch);
  const Report report = reconstruct(options);
  EXPECT_GE(estimate.scratch, report.scratch_peak_bytes);
  EXPECT_LE(estimate.scratch, 3 * report.scratch_peak_bytes);
  EXPECT_GE(estimate.outputs, bytes_in(folder / "m"));
  EXPECT_LE(estimate.outputs, 3 * bytes_in(folder / "m"));
}

TEST(DiskEstimate, CountsThePowerShape) {
  const TestFolder folder;
  const std::uint64_t points = 10000;
  put_bytes(folder / "cloud.f64", bumpy_ball(points));
  RunOptions options = options_in(folder);
  options.surface = SurfaceKind::kNone;
  options.tetrahedra = "";
  options.medial_axis = folder / "m.pvtp";
  const DiskEstimate without = estimate_disk(points, options);
  options.medial_axis_faces = true;
  const DiskEstimate estimate = estimate_disk(points, options);
  EXPECT_GT(estimate.scratch, without.scratch);
  EXPECT_GT(estimate.outputs, without.outputs);
  const Report report = reconstruct(options);
  EXPECT_GE(estimate.scratch, report.scratch_peak_bytes);
  EXPECT_LE(estimate.scratch, 3 * report.scratch_peak_bytes);
  EXPECT_GE(estimate.outputs, bytes_in(folder / "m"));
  EXPECT_LE(estimate.outputs, 3 * bytes_in(folder / "m"));
}

TEST(DiskEstimate, CountsTheCrust) {
  const TestFolder folder;
  const std::uint64_t points = 10000;
  put_bytes(folder / "cloud.f64", bumpy_ball(points));
  RunOptions options = options_in(folder);
  options.tetrahedra = "";
  for (const char* output : {"out.pvtp", "out.ply"}) {
    options.output = folder / output;
    options.surface = SurfaceKind::kSolid;
    const DiskEstimate solid = estimate_disk(points, options);
    options.surface = SurfaceKind::kCrust;
    const DiskEstimate estimate = estimate_disk(points, options);
    EXPECT_GT(estimate.scratch, solid.scratch);
    const Report report = reconstruct(options);
    EXPECT_GE(estimate.scratch, report.scratch_peak_bytes) << output;
    EXPECT_LE(estimate.scratch, 3 * report.scratch_peak_bytes) << output;
  }
  EXPECT_GE(estimate_disk(points, options).outputs, bytes_in(folder / "out"));
}

TEST(DiskEstimate, CountsOnlyWhatIsMade) {
  RunOptions options;
  options.surface = SurfaceKind::kNone;
  EXPECT_EQ(estimate_disk(1000, options).outputs, 0U);
  options.surface = SurfaceKind::kGamma;
  options.output = std::string("-");
  EXPECT_EQ(estimate_disk(1000, options).outputs, 0U);
  options.output = "a.pvtp";
  EXPECT_GT(estimate_disk(1000, options).outputs, 0U);
}

TEST(DiskOutlook, IsSaidBeforeTheWorkOnlyWhereItIsShort) {
  const TestFolder folder;
  write_cloud(folder);
  RunOptions options = options_in(folder);
  std::vector<std::string> notices;
  options.on_notice = [&](const std::string& notice) { notices.push_back(notice); };
  (void)reconstruct(options);
  EXPECT_THAT(notices, testing::IsEmpty());
  options.scratch_limit_bytes = 2'100'000;
  try {
    (void)reconstruct(options);
  } catch (const IoError&) {
    // A limit below the estimate may or may not do.
  }
  EXPECT_THAT(notices, testing::ElementsAre(HasSubstr("--scratch-limit is 2.0 MiB")));
}

TEST(DiskOutlook, TellsEachDiskWhatItHolds) {
  const TestFolder folder;
  RunOptions options = options_in(folder);
  const std::uint64_t free = free_bytes(folder.path());
  DiskEstimate estimate{free / 2, free / 4};
  EXPECT_FALSE(disk_outlook(estimate, options, 0).is_short);
  estimate.outputs = free;
  EXPECT_TRUE(disk_outlook(estimate, options, 0).is_short);
  // What a resumed run has there already is not needed again.
  estimate = {2 * free, 0};
  EXPECT_TRUE(disk_outlook(estimate, options, 0).is_short);
  EXPECT_FALSE(disk_outlook(estimate, options, 2 * free).is_short);
}

}  // namespace
}  // namespace stream_recon
