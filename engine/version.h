// The version of the program, as the build knows it.
//
// Thread rule: a constant.
#pragma once

namespace stream_recon {

/// For example "0.1.0".
const char* version();

}  // namespace stream_recon
