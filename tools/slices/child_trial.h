// Tries work in a child process first, because libraries end the process over damaged files:
// Debian's GDCM is built with assertions, and some of ITK's readers crash.
//
// Guarantees: the child writes nothing to standard output or error and leaves no core file.
// Thread rule: no other thread may hold a lock that the work needs. Cost: a fork (0.3 ms) and the
// work itself, which must be done once more here.
#pragma once

#include <functional>

namespace stream_recon {

/// False if the child crashed, or was still busy after a minute. An exception is no crash: `work`
/// will throw it here too.
bool survives_in_child(const std::function<void()>& work);

}  // namespace stream_recon
