// Where the pages of a TIFF file are described: its chain of image file directories.
//
// Guarantees: every directory lies within the file, up to the link to the next; libtiff takes a
// chain that leaves the file for one that has ended.
// Memory: 8 bytes a page. Cost: two small reads a page.
// Source: TIFF 6.0 (Adobe 1992), section 2; BigTIFF (libtiff.gitlab.io/libtiff/bigtiff.html).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace stream_recon {

/// Bytes at which the directories begin, in the order of the pages.
/// \throw InputError truncated, or the chain runs in a circle
std::vector<std::uint64_t> tiff_directories(const std::string& path);

}  // namespace stream_recon
