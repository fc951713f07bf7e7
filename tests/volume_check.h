// What tests of volume readers share: a whole volume in memory, the one line of a refusal, ITK's
// own reading of a file, and the voxels at the border of an object.
#pragma once

#include <itkImage.h>
#include <itkImageFileReader.h>
#include <itkImageFileWriter.h>

#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "io/error.h"
#include "tools/slices/open_volume.h"

namespace stream_recon {

inline VolumeRequest request_of(std::vector<std::string> paths, bool needs_spacing = false) {
  VolumeRequest request;
  request.paths = std::move(paths);
  request.needs_spacing = needs_spacing;
  return request;
}

inline std::vector<double> voxels_of(Volume& volume) {
  const auto& size = volume.geometry().size;
  const std::size_t slice = size[0] * size[1];
  std::vector<double> voxels(slice * size[2]);
  for (std::size_t k = 0; k < size[2]; ++k)
    volume.read_slice(k, std::span(voxels).subspan(k * slice, slice));
  return voxels;
}

/// What the refusal says; empty if the volume can be read to its end.
inline std::string refusal(const VolumeRequest& request) {
  try {
    voxels_of(*open_volume(request));
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}
inline std::string refusal(const std::string& path) {
  return refusal(request_of({path}));
}

template <typename AnyImage>
void write_image(const std::string& path, AnyImage* image, bool compressed) {
  const auto writer = itk::ImageFileWriter<AnyImage>::New();
  writer->SetFileName(path);
  writer->SetInput(image);
  writer->SetUseCompression(compressed);
  writer->Update();
}

inline itk::Image<double, 3>::Pointer read_with_itk(const std::string& path) {
  const auto reader = itk::ImageFileReader<itk::Image<double, 3>>::New();
  reader->SetFileName(path);
  reader->Update();
  return reader->GetOutput();
}

/// Voxels of the object with one of their 6 neighbours outside; beyond the edge is outside.
inline std::size_t count_boundary(Volume& volume, const std::function<bool(double)>& is_inside) {
  const auto [width, height, depth] = volume.geometry().size;
  std::vector<double> slice(width * height);
  // A frame of outside around each of three slices.
  const std::size_t row = width + 2;
  std::vector<std::vector<char>> inside(3, std::vector<char>(row * (height + 2), 0));
  std::size_t count = 0;
  for (std::size_t k = 0; k <= depth; ++k) {
    std::rotate(inside.begin(), inside.begin() + 1, inside.end());
    auto& next = inside[2];
    std::fill(next.begin(), next.end(), 0);
    if (k < depth) {
      volume.read_slice(k, slice);
      for (std::size_t j = 0; j < height; ++j)
        for (std::size_t i = 0; i < width; ++i)
          next[(j + 1) * row + i + 1] = is_inside(slice[j * width + i]) ? 1 : 0;
    }
    const auto& here = inside[1];
    for (std::size_t at = row; at + row < here.size(); ++at) {
      if (here[at] == 0) continue;
      const bool is_enclosed = here[at - 1] && here[at + 1] && here[at - row] && here[at + row] &&
                               inside[0][at] && next[at];
      count += is_enclosed ? 0 : 1;
    }
  }
  return count;
}

inline std::string shared_data(const std::string& name) {
  return STREAM_RECON_SHARED_DATA "/" + name;
}

}  // namespace stream_recon
