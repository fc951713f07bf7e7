#include "engine/report.h"

#include <nlohmann/json.hpp>

#include "io/atomic_output.h"

namespace stream_recon {
namespace {

using Json = nlohmann::ordered_json;

/// Puts lists of numbers on one line, which the library would break after each number.
std::string dump(Json json, const std::vector<Json::json_pointer>& lists) {
  std::vector<std::string> lines;
  for (const auto& list : lists) {
    lines.push_back(json[list].dump());
    json[list] = "list " + list.to_string();
  }
  std::string text = json.dump(2);
  for (std::size_t i = 0; i < lists.size(); ++i) {
    const std::string mark = "\"list " + lists[i].to_string() + "\"";
    text.replace(text.find(mark), mark.size(), lines[i]);
  }
  return text;
}

template <class Value>
Json json_or_null(const std::optional<Value>& value) {
  return value ? Json(*value) : Json();
}

Json memory_json(const std::vector<MemorySample>& samples) {
  Json seconds = Json::array();
  Json bytes = Json::array();
  for (const MemorySample& sample : samples) {
    seconds.push_back(sample.seconds);
    bytes.push_back(sample.resident_bytes);
  }
  return {{"seconds", std::move(seconds)}, {"resident_bytes", std::move(bytes)}};
}

Json poles_json(const PoleReport& poles) {
  return {{"count", poles.count},         {"coincident", poles.coincident},
          {"unbounded", poles.unbounded}, {"small", poles.small},
          {"inner", poles.inner},         {"outer", poles.outer},
          {"conflicts", poles.conflicts}};
}

Json power_json(const PowerReport& power) {
  return {{"windows", power.windows},
          {"poles", power.poles},
          {"guests", power.guests},
          {"rounds", power.rounds},
          {"walks", power.walks},
          {"tests", power.tests},
          {"unbounded_faces", power.unbounded_faces},
          {"seconds",
           {{"samples", power.seconds.samples},
            {"touching", power.seconds.touching},
            {"insert", power.seconds.insert},
            {"walk", power.seconds.walk},
            {"prove", power.seconds.prove},
            {"faces", power.seconds.faces}}}};
}

Json shape_json(const ShapeReport& shape) {
  return {{"vertices", shape.vertices},     {"edges", shape.edges},
          {"bare_edges", shape.bare_edges}, {"triangles", shape.triangles},
          {"tetrahedra", shape.tetrahedra}, {"euler", shape.euler()}};
}

Json hybrid_json(const HybridReport& hybrid) {
  return {{"holes", hybrid.holes},
          {"by_triangles", hybrid.by_triangles},
          {"by_crust", hybrid.by_crust},
          {"by_solid", hybrid.by_solid},
          {"left_out", hybrid.left_out},
          {"patch_triangles", hybrid.patch_triangles},
          {"kept_fills", hybrid.kept_fills},
          {"added_vertices", hybrid.added_vertices},
          {"unused_samples", hybrid.unused_samples}};
}

}  // namespace

std::string to_json(const Report& report) {
  Json stages = Json::array();
  for (const StageReport& stage : report.stages) {
    stages.push_back({{"name", stage.name},
                      {"start_seconds", stage.start_seconds},
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
        {"euler", report.surface.euler},
        {"components", report.surface.components},
        {"cavities", report.surface.cavities},
        {"genus", json_or_null(report.surface.genus)},
        {"volume", json_or_null(report.surface.volume)},
        {"area", report.surface.area},
        {"samples_on_surface", report.surface.samples_on_surface},
        {"unused_samples", report.surface.unused_samples},
        {"doubtful_fills", report.surface.doubtful_fills},
        {"forest_conflicts", report.surface.forest_conflicts},
        {"delta_histogram", report.surface.delta_histogram}}},
      {"windows",
       {{"count", report.windows.count},
        {"splits", report.windows.splits},
        {"guests", report.windows.guests},
        {"rounds", report.windows.rounds},
        {"queries", report.windows.queries},
        {"node_visits", report.windows.node_visits},
        {"exact_tests", report.windows.exact_tests},
        {"insert_seconds", report.windows.insert_seconds},
        {"search_seconds", report.windows.search_seconds}}},
      {"peak_rss_bytes", report.peak_rss_bytes},
      {"scratch_peak_bytes", report.scratch_peak_bytes},
      {"seconds", report.seconds},
      {"stages", std::move(stages)},
      {"threads", report.threads},
      {"memory_budget_bytes", report.memory_budget_bytes},
      {"memory_over_time", memory_json(report.memory_over_time)},
  };
  if (report.input.spacing) json["input"]["spacing"] = *report.input.spacing;
  if (report.poles) json["poles"] = poles_json(*report.poles);
  if (report.power) json["power"] = power_json(*report.power);
  if (report.shape) json["shape"] = shape_json(*report.shape);
  if (report.hybrid) json["hybrid"] = hybrid_json(*report.hybrid);
  using Pointer = Json::json_pointer;
  return dump(json, {Pointer("/surface/delta_histogram"), Pointer("/memory_over_time/seconds"),
                     Pointer("/memory_over_time/resident_bytes")}) +
         "\n";
}

void write_report(const Report& report, const std::string& path) {
  write_output(path, to_json(report));
}

}  // namespace stream_recon
