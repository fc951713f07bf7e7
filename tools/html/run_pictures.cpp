#include "tools/html/run_pictures.h"

#include <algorithm>
#include <cmath>
#include <exception>

#include "engine/process_memory.h"
#include "io/pvtp_index.h"
#include "io/vtp_document.h"
#include "tools/preview/preview.h"

namespace stream_recon::html {
namespace {

constexpr double kWidth = 720;
constexpr double kHeight = 720;
constexpr double kStripWidth = 1050;  // three views side by side
constexpr double kStripHeight = 420;
constexpr double kLeastShare = 0.25;  // of the sides; smaller ones show nothing

constexpr std::uint64_t kPixelBytes = 85;      // buffers, and the PNGs made before
constexpr std::uint64_t kTriangleBytes = 120;  // of a chunk while it is read and drawn
constexpr std::uint64_t kFixedBytes = std::uint64_t{6} << 20;
constexpr std::uint64_t kFileBytes = std::uint64_t{16} << 20;  // a part of a single file

std::uint64_t triangles_of(const std::string& chunk) {
  ByteSource source(chunk);
  VtpDocument document(source);
  const auto array = document.next();
  return array ? array->piece.polys : 0;
}

/// What drawing needs beside the pixels.
std::uint64_t part_bytes(const std::string& output) {
  if (!output.ends_with(".pvtp")) return kFixedBytes + kFileBytes;
  std::uint64_t most = 0;
  for (const std::string& chunk : read_pvtp_index(output)) {
    most = std::max(most, triangles_of(chunk));
  }
  return kFixedBytes + most * kTriangleBytes;
}

/// How much smaller than wished the sides must be; 0 for no picture.
double size_share(const std::string& output, std::uint64_t memory_bytes) {
  trim_allocator();
  const std::uint64_t needed = resident_bytes() + part_bytes(output);
  if (needed >= memory_bytes) return 0;
  const double pixels = static_cast<double>(memory_bytes - needed) / kPixelBytes;
  const double share = std::min(1.0, std::sqrt(pixels / (kWidth * kHeight)));
  return share < kLeastShare ? 0 : share;
}

RunPicture draw(const PreviewInput& input, const PreviewOptions& options, std::string caption) {
  RunPicture picture;
  picture.png = encode_png(draw_preview({input}, options));
  picture.width = options.width;
  picture.height = options.height;
  picture.caption = std::move(caption);
  return picture;
}

std::vector<RunPicture> draw_all(const std::string& output, double share) {
  const bool has_delta = !output.ends_with(".ply");
  PreviewOptions options{.width = static_cast<std::size_t>(share * kWidth),
                         .height = static_cast<std::size_t>(share * kHeight),
                         .views = parse_views("-35,20"),
                         .background = Background::transparent(),
                         .has_legend = false};
  std::vector<RunPicture> pictures;
  pictures.push_back(draw({output, {}}, options, "From the front right and above"));
  if (has_delta) {
    pictures.push_back(draw({output, {ColorBy::kDelta, {}}}, options,
                            "Coloured by the angle Delta of the triangles, as in the chart"));
  } else {
    options.views = parse_views("145,20");
    pictures.push_back(draw({output, {}}, options, "From the back left and above"));
  }
  options.views = parse_views("front,left,top");
  options.width = static_cast<std::size_t>(share * kStripWidth);
  options.height = static_cast<std::size_t>(share * kStripHeight);
  pictures.push_back(draw({output, {}}, options, "From the front, the left and the top"));
  return pictures;
}

}  // namespace

RunPictures draw_run_pictures(const std::string& output, std::uint64_t memory_bytes) {
  try {
    const double share = size_share(output, memory_bytes);
    if (share == 0) return {{}, "they would take more than the memory given to the run"};
    return {draw_all(output, share), ""};
  } catch (const std::exception& e) {
    return {{}, e.what()};
  }
}

}  // namespace stream_recon::html
