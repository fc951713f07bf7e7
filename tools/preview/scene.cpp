#include "tools/preview/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "io/error.h"

namespace stream_recon {
namespace {

constexpr std::size_t kMostEntries = 8;
/// Where the scale of closures ends: above 4 a fill is doubtful.
constexpr double kMostClosure = 6;
constexpr std::uint64_t kMostPoints = (std::uint64_t{1} << 31) - 1;

std::string with_commas(std::uint64_t number) {
  if (number < 1000) return std::to_string(number);
  return fmt::format("{},{:03}", with_commas(number / 1000), number % 1000);
}

std::string file_name(const std::string& path) {
  return path.substr(path.find_last_of('/') + 1);
}

/// Data that a colouring asks for must be there.
void require(bool holds, const std::string& path, const char* what) {
  if (!holds) throw std::invalid_argument(path + ": " + what + "; give another --color");
}

void check_data(const PreviewInput& input, const VtpMesh& part) {
  const bool has_triangles = !part.triangles.empty();
  switch (input.coloring.by) {
    case ColorBy::kDelta:
      return require(has_triangles && !part.delta.empty(), input.path, "it has no Delta");
    case ColorBy::kSource:
      return require(has_triangles && !part.source.empty(), input.path, "it has no Source");
    case ColorBy::kClosure:
      return require(has_triangles && !part.closure.empty(), input.path, "it has no Closure");
    case ColorBy::kComponent:
      require(has_triangles, input.path, "points alone have no components");
      return require(!part.global_ids.empty(), input.path,
                     "its chunks do not say which points they share (no GlobalPointId)");
    default:
      return;
  }
}

const char* source_name(std::uint8_t source) {
  constexpr const char* kNames[] = {"gamma", "alpha", "fill", "crust"};
  return source < std::size(kNames) ? kNames[source] : "other";
}

}  // namespace

Scene::Scene(const std::vector<PreviewInput>& inputs, const std::vector<NamedView>& views)
    : boxes_(views.size()) {
  for (const PreviewInput& input : inputs) {
    Piece& piece = pieces_.emplace_back();
    piece.input = input;
    piece.parts = open_mesh_parts(input.path);
    look_through(piece, views);
    if (input.coloring.by == ColorBy::kComponent) find_components(piece);
  }
}

void Scene::look_through(Piece& piece, const std::vector<NamedView>& views) {
  const auto extend = [&](const Point3& point) {
    for (std::size_t i = 0; i < views.size(); ++i) boxes_[i].extend(views[i].view(point));
  };
  piece.parts->for_each([&](const VtpMesh& part) {
    if (part.triangles.empty() && part.points.empty()) return;
    check_data(piece.input, part);
    piece.triangles += part.triangles.size();
    if (part.triangles.empty()) {
      piece.loose_points += part.points.size();
      for (const Point3& point : part.points) {
        if (is_finite(point)) extend(point);
      }
    }
    for (const auto& triangle : part.triangles) {
      for (const std::uint32_t corner : triangle) extend(part.points[corner]);
    }
    for (const float delta : part.delta) {
      piece.greatest_delta = std::max(piece.greatest_delta, static_cast<double>(delta));
    }
    piece.sources.insert(part.source.begin(), part.source.end());
    for (const std::uint64_t id : part.global_ids) {
      piece.point_numbers = std::max(piece.point_numbers, id == UINT64_MAX ? id : id + 1);
    }
  });
  if (piece.triangles == 0 && piece.loose_points == 0) {
    throw InputError(piece.input.path + ": nothing to draw; check how it was made");
  }
}

void Scene::find_components(Piece& piece) {
  if (piece.point_numbers > kMostPoints) {
    throw InputError(piece.input.path +
                     ": points are numbered beyond 2^31, too high for components; give another "
                     "--color");
  }
  Components& components = piece.components.emplace(piece.point_numbers);
  piece.parts->for_each([&components](const VtpMesh& part) {
    for (const auto& [a, b, c] : part.triangles) {
      components.join({part.global_ids[a], part.global_ids[b], part.global_ids[c]});
    }
  });
  components.rank();
}

double Scene::scale_end() const {
  double greatest = 0;
  for (const Piece& piece : pieces_) greatest = std::max(greatest, piece.greatest_delta);
  return greatest <= 90 ? 90 : 180;
}

Paint Scene::point_paint(std::size_t piece) const {
  switch (pieces_[piece].input.coloring.by) {
    case ColorBy::kPiece:
      return distinct_paint(piece);
    case ColorBy::kFixed:
      return static_cast<Paint>(kFixedPaints + piece);
    default:
      return distinct_paint(0);
  }
}

Paint Scene::paint(std::size_t piece, const VtpMesh& part, std::size_t triangle) {
  switch (pieces_[piece].input.coloring.by) {
    case ColorBy::kDelta:
      return scale_paint(static_cast<double>(part.delta[triangle]) / scale_end());
    case ColorBy::kSource:
      return distinct_paint(std::uint64_t{1} + part.source[triangle]);
    case ColorBy::kClosure:
      return scale_paint(static_cast<double>(part.closure[triangle]) / kMostClosure);
    case ColorBy::kComponent:
      return distinct_paint(
          pieces_[piece].components->rank_of(part.global_ids[part.triangles[triangle][0]]));
    default:
      return point_paint(piece);
  }
}

std::vector<Color> Scene::palette() const {
  std::vector<Rgb> fixed;
  for (const Piece& piece : pieces_) fixed.push_back(piece.input.coloring.fixed);
  return make_palette(fixed);
}

std::vector<LegendBlock> Scene::legend() const {
  const std::vector<Color> colors = palette();
  std::vector<LegendBlock> blocks;
  LegendBlock files{.title = "Files", .entries = {}};
  std::set<std::uint8_t> sources;
  bool has_scale = false;
  bool has_closure = false;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const Piece& piece = pieces_[i];
    const ColorBy by = piece.input.coloring.by;
    has_scale |= by == ColorBy::kDelta;
    has_closure |= by == ColorBy::kClosure;
    if (by == ColorBy::kSource) sources.insert(piece.sources.begin(), piece.sources.end());
    if (by == ColorBy::kPiece || by == ColorBy::kFixed) {
      files.entries.push_back({colors[point_paint(i)], file_name(piece.input.path)});
    }
    if (by != ColorBy::kComponent) continue;
    const std::uint64_t count = piece.components->count();
    LegendBlock& block = blocks.emplace_back();
    block.title = with_commas(count) + (count == 1 ? " component" : " components");
    for (std::uint64_t rank = 0; rank < std::min<std::uint64_t>(count, kMostEntries); ++rank) {
      block.entries.push_back(
          {colors[distinct_paint(rank)], with_commas(piece.components->size(rank)) + " points"});
    }
  }
  if (has_scale)
    blocks.push_back({.title = "Delta, degrees", .entries = {}, .scale_end = scale_end()});
  if (has_closure) {
    blocks.push_back({.title = "Closure, spacings", .entries = {}, .scale_end = kMostClosure});
  }
  if (!sources.empty()) {
    LegendBlock& block = blocks.emplace_back();
    block.title = "Source";
    for (const std::uint8_t source : sources) {
      block.entries.push_back(
          {colors[distinct_paint(std::uint64_t{1} + source)], source_name(source)});
    }
  }
  if (pieces_.size() > 1 && !files.entries.empty()) blocks.push_back(files);
  return blocks;
}

}  // namespace stream_recon
