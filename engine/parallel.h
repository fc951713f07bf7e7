// Work on all threads of the run; the only door to TBB.
//
// Guarantees: results do not depend on the number of threads when the caller's order is total and
// its ranges are independent. An exception in a body ends the loop and is thrown to the caller.
#pragma once

#if defined(__SANITIZE_THREAD__)
#include "engine/parallel_threads.h"
#else

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <cstddef>

namespace stream_recon {

/// Threads the machine offers this process.
inline unsigned default_threads() {
  return static_cast<unsigned>(tbb::info::default_concurrency());
}

/// Limits the threads of the process while it lives.
class ThreadLimit {
 public:
  explicit ThreadLimit(unsigned threads)
      : control_(tbb::global_control::max_allowed_parallelism, threads) {}

 private:
  tbb::global_control control_;
};

/// Threads that the loops below run on at most.
inline unsigned threads_in_use() {
  using Control = tbb::global_control;
  return static_cast<unsigned>(Control::active_value(Control::max_allowed_parallelism));
}

/// Sorts in place. \pre `less` is a total order on what is sorted.
template <class Iterator, class Less>
void parallel_sort(Iterator first, Iterator last, const Less& less) {
  tbb::parallel_sort(first, last, less);
}

/// Calls body(begin, end) for disjoint ranges of about `grain` that cover [0, count).
template <class Body>
void parallel_for_ranges(std::size_t count, std::size_t grain, const Body& body) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain),
                    [&body](const auto& range) { body(range.begin(), range.end()); });
}

}  // namespace stream_recon

#endif
