// Takes all finite tetrahedra that a window emits.
//
// Thread rule: consume() may run side by side with itself, one window each; each call is one loop.
// Memory: none.
#pragma once

#include "engine/chunks/chunk_layout.h"
#include "engine/interrupt.h"
#include "engine/windows/final_window.h"

namespace stream_recon {

class TetrahedraCollector : public WindowConsumer {
 public:
  /// \pre `stop` outlives the collector.
  TetrahedraCollector(const ChunkLayout& layout, const StopRequest& stop)
      : layout_(layout), stop_(stop) {}

  /// \throw IoError, Interrupted
  void consume(const FinalWindow& window, ExportWriter& out) override;

 private:
  ChunkLayout layout_;
  const StopRequest& stop_;
};

}  // namespace stream_recon
