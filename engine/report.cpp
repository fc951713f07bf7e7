#include "engine/report.h"

#include <nlohmann/json.hpp>
#include <span>

#include "io/atomic_output.h"
#include "io/file.h"

namespace stream_recon {

std::string to_json(const Report& report) {
  using Json = nlohmann::ordered_json;
  Json stages = Json::array();
  for (const StageReport& stage : report.stages) {
    stages.push_back({{"name", stage.name},
                      {"seconds", stage.seconds},
                      {"bytes_read", stage.bytes_read},
                      {"bytes_written", stage.bytes_written}});
  }
  Json json{
      {"version", report.version},
      {"input",
       {{"points", report.input.points},
        {"duplicates", report.input.duplicates},
        {"rejected", report.input.rejected}}},
      {"delaunay",
       {{"tetrahedra", report.delaunay.tetrahedra}, {"digest", report.delaunay.digest}}},
      {"surface",
       {{"kind", report.surface.kind},
        {"vertices", report.surface.vertices},
        {"triangles", report.surface.triangles},
        {"digest", report.surface.digest},
        {"boundary_edges", report.surface.boundary_edges},
        {"nonmanifold_edges", report.surface.nonmanifold_edges},
        {"euler", report.surface.euler}}},
      {"windows",
       {{"count", report.windows.count},
        {"splits", report.windows.splits},
        {"guests", report.windows.guests},
        {"rounds", report.windows.rounds},
        {"queries", report.windows.queries},
        {"node_visits", report.windows.node_visits},
        {"insert_seconds", report.windows.insert_seconds},
        {"search_seconds", report.windows.search_seconds}}},
      {"peak_rss_bytes", report.peak_rss_bytes},
      {"scratch_peak_bytes", report.scratch_peak_bytes},
      {"seconds", report.seconds},
      {"stages", std::move(stages)},
      {"threads", report.threads},
      {"memory_budget_bytes", report.memory_budget_bytes},
  };
  if (report.input.spacing) json["input"]["spacing"] = *report.input.spacing;
  return json.dump(2) + "\n";
}

void write_report(const Report& report, const std::string& path) {
  const std::string text = to_json(report);
  const auto bytes = std::as_bytes(std::span(text));
  if (path == "-") {
    File::standard_output().write(bytes);
    return;
  }
  AtomicOutput output(path);
  output.file().write(bytes);
  output.commit();
}

}  // namespace stream_recon
