// What engine/parallel.h offers, made of standard threads: for the thread sanitizer, which cannot
// see how the compiled library of TBB synchronizes and would report each of its loops as a race.
// The bodies, ours, run side by side as under TBB. Sorting is TBB's own and stays on one thread.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>

namespace stream_recon {

inline unsigned default_threads() {
  return std::max(1U, std::thread::hardware_concurrency());
}

class ThreadLimit {
 public:
  explicit ThreadLimit(unsigned /*threads*/) {}
};

inline unsigned threads_in_use() {
  return 4;
}

template <class Iterator, class Less>
void parallel_sort(Iterator first, Iterator last, const Less& less) {
  std::sort(first, last, less);
}

template <class Body>
void parallel_for_ranges(std::size_t count, std::size_t grain, const Body& body) {
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::exception_ptr error;
  const auto work = [&] {
    try {
      for (std::size_t begin = next.fetch_add(grain); begin < count;
           begin = next.fetch_add(grain)) {
        body(begin, std::min(begin + grain, count));
      }
    } catch (...) {
      next = count;
      const std::lock_guard lock(mutex);
      if (error == nullptr) error = std::current_exception();
    }
  };
  {
    std::array<std::jthread, 3> others;
    for (std::jthread& thread : others) thread = std::jthread(work);
    work();
  }
  if (error != nullptr) std::rethrow_exception(error);
}

}  // namespace stream_recon
