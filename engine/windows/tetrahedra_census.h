// Counts the tetrahedra of the cloud and takes their digest.
//
// Thread rule: consume() from many threads at once, each with its own window; the counts when all
// are through. Cost: about 15 ns a tetrahedron.
#pragma once

#include <cstdint>
#include <mutex>

#include "engine/windows/final_window.h"
#include "spatial/simplex_digest.h"

namespace stream_recon {

class TetrahedraCensus : public WindowConsumer {
 public:
  void consume(const FinalWindow& window) override;

  std::uint64_t count() const { return count_; }
  const SimplexDigest& digest() const { return digest_; }

 private:
  std::mutex mutex_;
  std::uint64_t count_ = 0;
  SimplexDigest digest_;
};

}  // namespace stream_recon
