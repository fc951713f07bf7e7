#include "engine/version.h"

namespace stream_recon {

const char* version() {
  return STREAM_RECON_VERSION;
}

}  // namespace stream_recon
