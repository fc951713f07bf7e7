// The samples that no triangle has, as a run leaves them.

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "tests/cli_program.h"

namespace stream_recon {
namespace {

constexpr std::size_t kPoint = 12;

/// The points of a binary PLY, as the bytes of three floats each.
std::vector<std::string> points_of(const std::string& ply) {
  const std::string mark = "element vertex ";
  const auto count = std::stoull(ply.substr(ply.find(mark) + mark.size()));
  const std::string end = "end_header\n";
  const std::size_t begin = ply.find(end) + end.size();
  std::vector<std::string> points;
  for (std::size_t i = 0; i < count; ++i) points.push_back(ply.substr(begin + i * kPoint, kPoint));
  return points;
}

TEST(Unused, AndTheVerticesAreTheInputBitForBit) {
  const CommandFolder folder;
  ASSERT_EQ(folder.run("make-cloud folded -n 9000 --scalar float -o a.ply").exit_code, 0);
  // Noise inside the body, on no regular triangle, and a point twice.
  ASSERT_EQ(folder.run("make-cloud cube -n 3000 --scalar float -o b.ply").exit_code, 0);
  std::string run = "stream-recon a.ply b.ply a.ply --surface alpha --alpha 0.02 ";
  const Outcome outcome =
      folder.run(run + "-o s.ply --unused u.ply --report r.json --chunk-points 700");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  const auto report = folder.json("r.json");
  const auto unused = points_of(folder.bytes("u.ply"));
  EXPECT_EQ(unused.size(), report["surface"]["unused_samples"]);
  EXPECT_GT(unused.size(), 100U);
  std::multiset<std::string> found(unused.begin(), unused.end());
  for (const std::string& vertex : points_of(folder.bytes("s.ply"))) found.insert(vertex);
  std::set<std::string> expected;
  for (const char* name : {"a.ply", "b.ply"}) {
    for (const std::string& point : points_of(folder.bytes(name))) expected.insert(point);
  }
  EXPECT_TRUE(std::equal(found.begin(), found.end(), expected.begin(), expected.end()));
  EXPECT_EQ(report["surface"]["samples_on_surface"], report["surface"]["vertices"]);

  run += "--unused n.ply ";
  for (const std::string options :
       {"-o n.pvtp --threads 1", "-o n.pvtp --threads 4 --chunk-points 700",
        "-o n.vtk --memory 80M --chunk-points 50"}) {
    const Outcome next = folder.run(run + options);
    ASSERT_EQ(next.exit_code, 0) << next.error;
    EXPECT_EQ(folder.bytes("n.ply") == folder.bytes("u.ply"), true) << options;
  }
}

TEST(Unused, OfARunThatFailsLeaveTheOlderOnesAlone) {
  const CommandFolder folder;
  ASSERT_EQ(folder.run("make-cloud cube -n 2000 -o cloud.ply; echo older >u.ply").exit_code, 0);
  EXPECT_EQ(
      folder.run("stream-recon cloud.ply -o s.pvtp --unused u.ply --scratch-limit 20K").exit_code,
      74);
  EXPECT_EQ(folder.bytes("u.ply"), "older\n");
  // A folder that is no surface's is found in the way.
  EXPECT_EQ(folder
                .run("mkdir s && touch s/mine && "
                     "stream-recon cloud.ply -o s.pvtp --unused u.ply")
                .exit_code,
            74);
  EXPECT_EQ(folder.bytes("u.ply"), "older\n");
  EXPECT_EQ(folder.run("rm -r s; stream-recon cloud.ply -o s.pvtp --unused u.ply").exit_code, 0);
  EXPECT_EQ(folder.bytes("u.ply").substr(0, 4), "ply\n");
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"cloud.ply", "s", "s.pvtp", "u.ply"}));
}

}  // namespace
}  // namespace stream_recon
