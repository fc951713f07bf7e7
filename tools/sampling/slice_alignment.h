// How far each slice of a stack must be moved in its plane to fit its neighbours.
//
// Text: a line "K DI DJ" for each slice that moves: its number from 0, then the offsets along i and
// j in voxels, which need not be whole. Blanks, tabs or commas; comments from '#'.
// Thread rule: values.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace stream_recon {

struct SliceOffset {
  double di = 0;
  double dj = 0;
};

/// One offset a slice, `slices` of them. \throw InputError malformed (with file and line); IoError
std::vector<SliceOffset> read_slice_alignment(const std::string& path, std::size_t slices);

}  // namespace stream_recon
