// Work on chunks side by side: each is made, then taken.
//
// Guarantees: make(chunk) for every chunk below `chunks` by several threads at once, at most
// `at_once`, and take(chunk, result) once for every chunk: in ascending order, one at a time, or
// else side by side as results come. A chunk whose make() runs out of memory beside others is made
// again when it is alone: BudgetError means that one chunk alone does not fit. Other errors end the
// loop. Thread rule: one caller. Memory: what the results in hand hold, at most `at_once`; a byte a
// chunk.
#pragma once

#include <algorithm>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "engine/budget.h"
#include "engine/parallel.h"

namespace stream_recon {

struct ChunkLoopOptions {
  std::uint64_t chunks = 0;
  std::uint64_t at_once = 1;
  bool takes_in_order = false;
};

/// As many chunks of `bytes` each as there are threads and memory for.
inline std::uint64_t chunks_at_once(std::uint64_t bytes, const MemoryBudget& budget) {
  return std::clamp<std::uint64_t>(budget.available() / std::max<std::uint64_t>(bytes, 1), 1,
                                   threads_in_use());
}

namespace detail {

template <class Make, class Take>
class ChunkLoop {
 public:
  ChunkLoop(const ChunkLoopOptions& options, const Make& make, const Take& take)
      : options_(options), make_(make), take_(take), taken_(options.chunks, 0) {}

  void run() {
    const std::uint64_t workers = std::min(options_.at_once, options_.chunks);
    if (workers > 1) {
      parallel_for_ranges(workers, 1, [this](std::size_t begin, std::size_t end) {
        for (; begin < end; ++begin) work();
      });
    }
    for (std::uint64_t chunk = 0; chunk < options_.chunks; ++chunk) {
      if (taken_[chunk] == 0) take_(chunk, make_(chunk));
    }
  }

 private:
  using Result = decltype(std::declval<const Make&>()(std::uint64_t{}));

  /// One worker: chunks in ascending order until none is left or one did not fit.
  void work() {
    try {
      for (std::uint64_t chunk = next(); chunk < options_.chunks; chunk = next()) {
        std::optional<Result> result = make_beside_others(chunk);
        if (!result || !is_its_turn(chunk)) return;
        take_(chunk, std::move(*result));
        result.reset();
        end_turn(chunk);
      }
    } catch (...) {
      stop();
      throw;
    }
  }

  std::uint64_t next() {
    const std::lock_guard lock(mutex_);
    return is_stopped_ ? options_.chunks : next_++;
  }

  std::optional<Result> make_beside_others(std::uint64_t chunk) {
    try {
      return make_(chunk);
    } catch (const BudgetError&) {
      stop();
      return std::nullopt;
    }
  }

  /// Waits where the order matters; false if the chunk must be left for later. The chunk whose turn
  /// it is was begun before all that wait, by a thread that does not wait: no waiting in a circle.
  bool is_its_turn(std::uint64_t chunk) {
    if (!options_.takes_in_order) return true;
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return turn_ == chunk || is_stopped_; });
    return turn_ == chunk;
  }

  void end_turn(std::uint64_t chunk) {
    const std::lock_guard lock(mutex_);
    taken_[chunk] = 1;
    ++turn_;
    changed_.notify_all();
  }

  void stop() {
    const std::lock_guard lock(mutex_);
    is_stopped_ = true;
    changed_.notify_all();
  }

  const ChunkLoopOptions options_;
  const Make& make_;
  const Take& take_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::uint64_t next_ = 0;
  std::uint64_t turn_ = 0;
  bool is_stopped_ = false;
  std::vector<std::uint8_t> taken_;
};

}  // namespace detail

/// \pre make() and take() start no parallel loops of their own.
template <class Make, class Take>
void for_each_chunk(const ChunkLoopOptions& options, const Make& make, const Take& take) {
  detail::ChunkLoop<Make, Take>(options, make, take).run();
}

}  // namespace stream_recon
