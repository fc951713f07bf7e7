// The keys of the report are a contract with other programs.

#include "engine/report.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/error.h"
#include "tests/io_test_folder.h"

namespace stream_recon {
namespace {

TEST(Report, HasTheKeysOfTheContract) {
  Report report;
  report.surface.euler = -82;
  report.stages.push_back({"ingest", 0, 0.5, 100, 200});
  const auto json = nlohmann::json::parse(to_json(report));
  for (const char* key : {"/input/points",
                          "/input/duplicates",
                          "/input/rejected",
                          "/delaunay/tetrahedra",
                          "/delaunay/digest",
                          "/surface/kind",
                          "/surface/vertices",
                          "/surface/triangles",
                          "/surface/digest",
                          "/surface/boundary_edges",
                          "/surface/nonmanifold_edges",
                          "/surface/euler",
                          "/surface/components",
                          "/surface/cavities",
                          "/surface/genus",
                          "/surface/volume",
                          "/surface/area",
                          "/surface/samples_on_surface",
                          "/surface/unused_samples",
                          "/surface/doubtful_fills",
                          "/surface/forest_conflicts",
                          "/windows/count",
                          "/windows/guests",
                          "/windows/rounds",
                          "/peak_rss_bytes",
                          "/scratch_peak_bytes",
                          "/seconds",
                          "/stages/0/name",
                          "/stages/0/seconds",
                          "/stages/0/bytes_read",
                          "/stages/0/bytes_written",
                          "/threads",
                          "/memory_budget_bytes",
                          "/version"}) {
    EXPECT_TRUE(json.contains(nlohmann::json::json_pointer(key))) << key;
  }
  EXPECT_EQ(json["surface"]["euler"], -82);
  EXPECT_EQ(json["stages"][0]["bytes_written"], 200);
}

TEST(Report, HasGenusAndVolumeOnlyOfClosedSolids) {
  Report report;
  EXPECT_TRUE(nlohmann::json::parse(to_json(report)).at("surface").at("genus").is_null());
  EXPECT_TRUE(nlohmann::json::parse(to_json(report)).at("surface").at("volume").is_null());
  report.surface.genus = 42;
  report.surface.volume = 0.125;
  EXPECT_EQ(nlohmann::json::parse(to_json(report)).at("surface").at("genus"), 42);
  EXPECT_EQ(nlohmann::json::parse(to_json(report)).at("surface").at("volume"), 0.125);
}

TEST(Report, HasTheSpacingOfTheSamplesWhereItIsKnown) {
  Report report;
  EXPECT_FALSE(nlohmann::json::parse(to_json(report)).at("input").contains("spacing"));
  report.input.spacing = {0.5, 0.5, 1.5};
  EXPECT_EQ(nlohmann::json::parse(to_json(report)).at("input").at("spacing"),
            nlohmann::json({0.5, 0.5, 1.5}));
}

TEST(Report, IsCompleteUnderItsNameOrNotThere) {
  const TestFolder folder;
  write_report({}, folder / "report.json");
  EXPECT_EQ(folder.names(), std::vector<std::string>{"report.json"});
  EXPECT_EQ(file_bytes(folder / "report.json"), to_json({}));
  EXPECT_THROW(write_report({}, folder / "missing/report.json"), IoError);
}

}  // namespace
}  // namespace stream_recon
