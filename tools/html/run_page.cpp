#include "tools/html/run_page.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/atomic_output.h"
#include "tools/html/chart.h"
#include "tools/html/page_style.h"
#include "tools/html/run_figures.h"
#include "tools/html/text.h"

namespace stream_recon::html {
namespace {

std::string section(const std::string& title, const std::string& content) {
  return fmt::format("<section><h2>{}</h2>\n{}</section>\n", title, content);
}

/// A word as a shell would need it typed.
std::string quoted(const std::string& word) {
  constexpr std::string_view kPlain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_=+.,:/@%";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string text = "'";
  for (const char c : word) {
    if (c == '\'') {
      text += "'\\''";
    } else {
      text += c;
    }
  }
  text += '\'';
  return text;
}

std::string command(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) {
    if (!line.empty()) line += ' ';
    line += quoted(word);
  }
  return escape(line);
}

std::string joined(const std::vector<std::string>& names, const char* between) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : between) + escape(name);
  return text;
}

std::string file_name(const std::string& path) {
  if (path == "-") return "standard input";
  return path.substr(path.find_last_of('/') + 1);
}

std::string title(const RunPage& page) {
  if (page.inputs.empty()) return "A run";
  std::string text = escape(file_name(page.inputs.front()));
  if (page.inputs.size() > 1) {
    text += fmt::format(" and {} more", count(std::uint64_t{page.inputs.size() - 1}));
  }
  return text;
}

std::string tile(const std::string& value, const std::string& what) {
  return fmt::format("<div class=\"tile\"><b>{}</b><span>{}</span></div>\n", value, what);
}

std::string tiles(const Report& report) {
  const double rate =
      report.seconds > 0 ? static_cast<double>(report.input.points) / report.seconds : 0.0;
  const std::string size = has_surface(report)
                               ? tile(count(report.surface.triangles), "triangles")
                               : tile(count(report.delaunay.tetrahedra), "tetrahedra");
  return "<div class=\"tiles\">\n" + tile(count(report.input.points), "points") + size +
         tile(duration(report.seconds),
              count(static_cast<std::uint64_t>(rate)) + " points a second") +
         tile(bytes(report.peak_rss_bytes),
              "of " + bytes(report.memory_budget_bytes) + " memory at the peak") +
         "</div>\n";
}

std::string figure(const RunPicture& picture, bool is_wide) {
  return fmt::format(
      "<figure{}><img src=\"data:image/png;base64,{}\" width=\"{}\" height=\"{}\" "
      "alt=\"{}\"><figcaption>{}</figcaption></figure>\n",
      is_wide ? " class=\"wide\"" : "", base64(picture.png), picture.width, picture.height,
      escape(picture.caption), escape(picture.caption));
}

std::string pictures(const RunPictures& drawn) {
  if (drawn.pictures.empty()) {
    if (drawn.reason.empty()) return "";
    return "<p class=\"hint\">No pictures: " + escape(drawn.reason) + ".</p>\n";
  }
  std::string text;
  for (const RunPicture& picture : drawn.pictures) {
    text += figure(picture, picture.width > 2 * picture.height);
  }
  return "<section><div class=\"pictures\">\n" + text + "</div></section>\n";
}

std::string stage_rows(const Report& report) {
  double longest = 0;
  for (const StageReport& stage : report.stages) longest = std::max(longest, stage.seconds);
  std::string rows;
  for (const StageReport& stage : report.stages) {
    rows += fmt::format(
        "<tr><th scope=\"row\">{}</th><td class=\"bar\"><i style=\"width:{:.2f}%\"></i></td>"
        "<td class=\"number\">{}</td><td class=\"number\">{}</td><td class=\"number\">{}</td>"
        "<td class=\"number\">{}</td></tr>\n",
        escape(stage.name), longest > 0 ? 100 * stage.seconds / longest : 0.0,
        duration(stage.seconds), share(stage.seconds, report.seconds), bytes(stage.bytes_read),
        bytes(stage.bytes_written));
  }
  return rows;
}

std::string stages(const Report& report) {
  return section("Stages",
                 "<table><thead><tr><th scope=\"col\">stage</th><th class=\"bar\"></th>"
                 "<th class=\"number\" scope=\"col\">time</th>"
                 "<th class=\"number\" scope=\"col\">share</th>"
                 "<th class=\"number\" scope=\"col\">read</th>"
                 "<th class=\"number\" scope=\"col\">written</th></tr></thead>\n<tbody>\n" +
                     stage_rows(report) + "</tbody></table>\n");
}

std::string charts(const Report& report) {
  std::string memory = section("Memory over time", memory_chart(report));
  if (!has_surface(report)) return memory;
  const std::string delta =
      section("Triangles by angle Delta",
              delta_chart(report.surface.delta_histogram) +
                  "<p class=\"hint\">Delta is the angle at which the two empty balls of a triangle "
                  "meet.</p>\n");
  return "<div class=\"pair charts\">\n" + memory + delta + "</div>\n";
}

std::string head(const RunPage& page) {
  std::string text = "<p class=\"kicker\">stream-recon " + escape(page.report.version) +
                     "</p>\n<h1>" + title(page) + "</h1>\n";
  if (!page.outputs.empty()) {
    text += "<p class=\"kicker\">" + escape(page.report.surface.kind) + " surface \xE2\x86\x92 " +
            joined(page.outputs, ", ") + "</p>\n";
  }
  if (!page.note.empty()) text += "<p class=\"note\">" + escape(page.note) + "</p>\n";
  return text;
}

}  // namespace

std::string run_page(const RunPage& page) {
  return fmt::format(
             "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
             "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
             "<link rel=\"icon\" href=\"data:,\">\n"
             "<title>{} \xC2\xB7 "
             "stream-recon</title>\n<style>{}</style>\n</head>\n<body>\n<main>\n",
             title(page), kPageStyle) +
         head(page) + tiles(page.report) + pictures(page.pictures) + charts(page.report) +
         stages(page.report) + run_figures(page.report) +
         section("Command", "<code>" + command(page.command) + "</code>\n") +
         "</main>\n</body>\n</html>\n";
}

void write_run_page(const RunPage& page, const std::string& path) {
  write_output(path, run_page(page));
}

}  // namespace stream_recon::html
