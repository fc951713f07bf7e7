#include "engine/restart/manifest.h"

#include <array>
#include <nlohmann/json.hpp>
#include <span>

#include "io/checksum.h"

namespace stream_recon {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kFormat = 1;

Json point_json(const Point3& p) {
  return Json::array({p.x, p.y, p.z});
}

Point3 point_from(const Json& json) {
  return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

Json cloud_json(const CloudSummary& cloud) {
  Json json{{"points", cloud.points},
            {"rejected", cloud.rejected},
            {"far_points", cloud.far_points},
            {"bytes", cloud.bytes},
            {"low", point_json(cloud.box.low)},
            {"high", point_json(cloud.box.high)},
            {"unit_exponent", cloud.range.unit_exponent},
            {"magnitude_exponent", cloud.range.magnitude_exponent},
            {"fits_float32", cloud.fits_float32}};
  if (cloud.spacing) json["spacing"] = *cloud.spacing;
  return json;
}

CloudSummary cloud_from(const Json& json) {
  CloudSummary cloud;
  json.at("points").get_to(cloud.points);
  json.at("rejected").get_to(cloud.rejected);
  json.at("far_points").get_to(cloud.far_points);
  json.at("bytes").get_to(cloud.bytes);
  cloud.box = {point_from(json.at("low")), point_from(json.at("high"))};
  json.at("unit_exponent").get_to(cloud.range.unit_exponent);
  json.at("magnitude_exponent").get_to(cloud.range.magnitude_exponent);
  json.at("fits_float32").get_to(cloud.fits_float32);
  if (json.contains("spacing")) cloud.spacing = json.at("spacing").get<SampleSpacing>();
  return cloud;
}

Json windows_json(const WindowProgress& progress) {
  Json done = Json::array();
  for (const OwnedRange& range : progress.done) done.push_back({range.first, range.count});
  const WindowTotals& totals = progress.totals;
  return {{"done", done},
          {"count", totals.windows},
          {"splits", totals.splits},
          {"guests", totals.counts.guests},
          {"rounds", totals.counts.rounds},
          {"queries", totals.counts.search.queries},
          {"node_visits", totals.counts.search.node_visits},
          {"exact_tests", totals.counts.search.exact_tests},
          {"insert_seconds", totals.counts.insert_seconds},
          {"search_seconds", totals.counts.search_seconds},
          {"tetrahedra", totals.tetrahedra.count},
          {"digest", totals.tetrahedra.digest.value()},
          {"export_files", totals.export_files},
          {"export_records", totals.export_records}};
}

WindowProgress windows_from(const Json& json) {
  WindowProgress progress;
  for (const Json& range : json.at("done")) {
    progress.done.push_back({range.at(0).get<PointRank>(), range.at(1).get<std::uint64_t>()});
  }
  WindowTotals& totals = progress.totals;
  json.at("count").get_to(totals.windows);
  json.at("splits").get_to(totals.splits);
  json.at("guests").get_to(totals.counts.guests);
  json.at("rounds").get_to(totals.counts.rounds);
  json.at("queries").get_to(totals.counts.search.queries);
  json.at("node_visits").get_to(totals.counts.search.node_visits);
  json.at("exact_tests").get_to(totals.counts.search.exact_tests);
  json.at("insert_seconds").get_to(totals.counts.insert_seconds);
  json.at("search_seconds").get_to(totals.counts.search_seconds);
  json.at("tetrahedra").get_to(totals.tetrahedra.count);
  totals.tetrahedra.digest = SimplexDigest(json.at("digest").get<std::uint64_t>());
  json.at("export_files").get_to(totals.export_files);
  json.at("export_records").get_to(totals.export_records);
  return progress;
}

std::string checksum_line(const std::string& body) {
  return std::to_string(checksum64(std::as_bytes(std::span(body)))) + "\n";
}

}  // namespace

std::string to_text(const Manifest& manifest) {
  Json json{{"format", kFormat}, {"run", manifest.identity}};
  if (manifest.cloud) json["cloud"] = cloud_json(*manifest.cloud);
  if (manifest.order) {
    json["order"] = {{"points", manifest.order->point_count},
                     {"duplicates", manifest.order->duplicates}};
  }
  json["windows"] = windows_json(manifest.windows);
  const std::string body = json.dump(1) + "\n";
  return body + checksum_line(body);
}

std::optional<Manifest> manifest_from_text(const std::string& text) {
  const std::string::size_type end = text.rfind("}\n");
  if (end == std::string::npos) return std::nullopt;
  const std::string body = text.substr(0, end + 2);
  if (text.substr(end + 2) != checksum_line(body)) return std::nullopt;
  try {
    const Json json = Json::parse(body);
    if (json.at("format") != kFormat) return std::nullopt;
    Manifest manifest;
    json.at("run").get_to(manifest.identity);
    if (json.contains("cloud")) manifest.cloud = cloud_from(json.at("cloud"));
    if (json.contains("order")) {
      const Json& order = json.at("order");
      manifest.order = {order.at("points").get<std::uint64_t>(),
                        order.at("duplicates").get<std::uint64_t>()};
    }
    manifest.windows = windows_from(json.at("windows"));
    return manifest;
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

}  // namespace stream_recon
