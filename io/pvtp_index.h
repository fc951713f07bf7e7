// The index of a chunked surface (.pvtp): the files its pieces are in.
//
// Guarantees: paths in the order of the index, ready to open: those relative in the file are put
// behind the index' folder. Memory: the list. Thread rule: stateless.
#pragma once

#include <string>
#include <vector>

namespace stream_recon {

/// \throw InputError no index of PolyData pieces; IoError
std::vector<std::string> read_pvtp_index(const std::string& path);

}  // namespace stream_recon
