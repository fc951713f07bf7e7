#include "tools/sampling/label_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "io/error.h"

namespace stream_recon {
namespace {

constexpr std::size_t kMostLabels = std::size_t{1} << 16;
constexpr std::size_t kMostListed = 12;  // runs of labels in a message

/// Cells [first, last) of a row that have one value.
struct Run {
  std::size_t first, last, j, k;
};

class LabelFinder {
 public:
  void take(double label, const Run& run) {
    if (label == 0 || !std::isfinite(label)) return;
    if (label != std::floor(label)) {
      throw InputError(
          fmt::format("a voxel has the value {}, which is no label; use --iso or "
                      "--above for grey values",
                      label));
    }
    const auto [at, is_new] = extents_.try_emplace(label);
    LabelExtent& extent = at->second;
    if (is_new) {
      if (extents_.size() > kMostLabels) {
        throw InputError(
            fmt::format("more than {} different values: no label volume; use --iso or "
                        "--above for grey values",
                        kMostLabels));
      }
      extent = {label, 0, {{run.first, run.j, run.k}, {run.last, run.j + 1, run.k + 1}}};
    }
    extent.cells += run.last - run.first;
    widen(extent.box, run);
  }

  std::vector<LabelExtent> result() const {
    std::vector<LabelExtent> labels;
    for (const auto& [label, extent] : extents_) labels.push_back(extent);
    return labels;
  }

 private:
  static void widen(GridBox& box, const Run& run) {
    box.low = {std::min(box.low[0], run.first), std::min(box.low[1], run.j),
               std::min(box.low[2], run.k)};
    box.high = {std::max(box.high[0], run.last), std::max(box.high[1], run.j + 1),
                std::max(box.high[2], run.k + 1)};
  }

  std::map<double, LabelExtent> extents_;
};

}  // namespace

std::vector<LabelExtent> find_labels(Grid& grid) {
  LabelFinder finder;
  const auto [width, height, depth] = grid.size();
  std::vector<double> slice(grid.slice_cells());
  for (std::size_t k = 0; k < depth; ++k) {
    grid.read_slice(k, slice);
    for (std::size_t j = 0; j < height; ++j) {
      const double* row = &slice[j * width];
      for (std::size_t first = 0, last = 0; first < width; first = last) {
        const double label = row[first];
        while (last < width && (row[last] == label || last == first)) ++last;
        finder.take(label, {first, last, j, k});
      }
    }
  }
  return finder.result();
}

std::string label_list(const std::vector<LabelExtent>& labels) {
  std::string text;
  std::size_t runs = 0;
  for (std::size_t first = 0, last = 0; first < labels.size(); first = last + 1, ++runs) {
    if (runs == kMostListed) return text + ", ...";
    last = first;
    while (last + 1 < labels.size() && labels[last + 1].label == labels[last].label + 1) ++last;
    if (!text.empty()) text += ", ";
    text += fmt::format("{}", labels[first].label);
    if (last > first) text += fmt::format(" to {}", labels[last].label);
  }
  return text.empty() ? "none" : text;
}

}  // namespace stream_recon
