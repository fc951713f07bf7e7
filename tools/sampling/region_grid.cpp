#include "tools/sampling/region_grid.h"

#include <fmt/format.h>

#include <charconv>
#include <stdexcept>

namespace stream_recon {
namespace {

constexpr const char* kAxes = "ijk";

std::optional<std::size_t> parse_end(const std::string& text, const std::string& whole) {
  if (text.empty()) return std::nullopt;
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc{} && end == text.data() + text.size()) return value;
  throw std::invalid_argument(fmt::format(
      "--roi {}: \"{}\" is no voxel number; write for example 10:200,:,5:40", whole, text));
}

}  // namespace

RegionOfInterest parse_region(const std::string& text) {
  RegionOfInterest region;
  std::size_t at = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t comma = axis < 2 ? text.find(',', at) : text.size();
    const std::size_t colon = text.find(':', at);
    if (comma == std::string::npos || colon == std::string::npos || colon > comma) {
      throw std::invalid_argument(
          fmt::format("--roi {}: give I0:I1,J0:J1,K0:K1, for example 10:200,:,5:40", text));
    }
    region[axis] = {parse_end(text.substr(at, colon - at), text),
                    parse_end(text.substr(colon + 1, comma - colon - 1), text)};
    at = comma + 1;
  }
  return region;
}

GridBox box_of(const RegionOfInterest& region, const GridSize& size) {
  GridBox box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.low[axis] = region[axis].first.value_or(0);
    box.high[axis] = region[axis].second.value_or(size[axis]);
    if (box.low[axis] < box.high[axis] && box.high[axis] <= size[axis]) continue;
    throw std::invalid_argument(fmt::format(
        "--roi: {}:{} along {} is empty or leaves the volume, which has {} voxels there",
        box.low[axis], box.high[axis], kAxes[axis], size[axis]));
  }
  return box;
}

RegionGrid::RegionGrid(Volume& volume, const GridBox& box, const GridSize& every)
    : volume_(volume), box_(box), every_(every) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    size_[axis] = (box.extent(axis) + every[axis] - 1) / every[axis];
  }
  const GridSize& whole = volume.geometry().size;
  slice_.resize(whole[0] * whole[1]);
}

void RegionGrid::read_slice(std::size_t k, std::span<double> out) {
  volume_.read_slice(box_.low[2] + k * every_[2], slice_);
  const std::size_t width = volume_.geometry().size[0];
  std::size_t at = 0;
  for (std::size_t j = 0; j < size_[1]; ++j) {
    const double* row = &slice_[(box_.low[1] + j * every_[1]) * width + box_.low[0]];
    for (std::size_t i = 0; i < size_[0]; ++i) out[at++] = row[i * every_[0]];
  }
}

}  // namespace stream_recon
