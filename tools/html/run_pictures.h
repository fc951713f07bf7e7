// Pictures of a surface that a run has written, within the memory the run was given.
//
// Guarantees: none is drawn that would need more; the picture gets smaller first. A result that
// cannot be drawn is no error: a page does without. Memory: see tools/preview/preview.h.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace stream_recon::html {

struct RunPicture {
  std::string png;  ///< the bytes of the file
  std::size_t width = 0;
  std::size_t height = 0;
  std::string caption;
};

struct RunPictures {
  std::vector<RunPicture> pictures;
  std::string reason;  ///< why there are none, if there are none
};

/// \param output .pvtp, .ply or .vtk, complete
/// \param memory_bytes bound of the resident set of the process
RunPictures draw_run_pictures(const std::string& output, std::uint64_t memory_bytes);

}  // namespace stream_recon::html
