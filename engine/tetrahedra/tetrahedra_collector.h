// Takes all finite tetrahedra that a window emits.
//
// Thread rule: consume() may run side by side with itself, one window each; each call is one loop.
// Memory: 64 KiB a call.
#pragma once

#include "engine/interrupt.h"
#include "engine/tetrahedra/tetrahedra_sink.h"
#include "engine/windows/final_window.h"

namespace stream_recon {

class TetrahedraCollector : public WindowConsumer {
 public:
  /// \pre `sink` and `stop` outlive the collector.
  TetrahedraCollector(TetrahedraSink& sink, const StopRequest& stop) : sink_(sink), stop_(stop) {}

  /// \throw IoError, Interrupted
  void consume(const FinalWindow& window) override;

 private:
  TetrahedraSink& sink_;
  const StopRequest& stop_;
};

}  // namespace stream_recon
