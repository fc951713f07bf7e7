// Merges sorted streams of records into one sorted stream.
//
// Guarantees: next() delivers the records of all streams in order, if each is in order; of equal
// ones, in no promised order. Thread rule: one thread. Memory: the streams, and `batch` records of
// each. Cost: two to the logarithm of the streams comparisons a record.
// Source: Knuth, The Art of Computer Programming 3, section 5.4.1.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace stream_recon {

/// \tparam Stream read(span) fills the front with the next records; their number, less than asked
/// only at the end
template <class Record, class Stream, class Less = std::less<Record>>
class StreamMerger {
 public:
  /// \param batch records read at once \throw as the streams' read()
  StreamMerger(std::vector<std::unique_ptr<Stream>> streams, std::size_t batch) : batch_(batch) {
    inputs_.resize(streams.size());
    for (std::size_t i = 0; i < streams.size(); ++i) {
      inputs_[i].stream = std::move(streams[i]);
      if (refill(inputs_[i])) push(i);
    }
  }

  /// \return The number of the stream it came from; nothing at the end. \throw as read()
  std::optional<std::size_t> next(Record& record) {
    if (heap_.empty()) return std::nullopt;
    std::pop_heap(heap_.begin(), heap_.end(), Later{&inputs_});
    const std::size_t winner = heap_.back();
    heap_.pop_back();
    Input& input = inputs_[winner];
    record = input.front();
    ++input.next;
    if (input.next < input.buffer.size() || refill(input)) push(winner);
    return winner;
  }

 private:
  struct Input {
    std::unique_ptr<Stream> stream;
    std::vector<Record> buffer;
    std::size_t next = 0;

    const Record& front() const { return buffer[next]; }
  };

  struct Later {
    const std::vector<Input>* inputs;
    bool operator()(std::size_t a, std::size_t b) const {
      return Less{}((*inputs)[b].front(), (*inputs)[a].front());
    }
  };

  bool refill(Input& input) const {
    input.buffer.resize(batch_);
    input.buffer.resize(input.stream->read(std::span<Record>(input.buffer)));
    input.next = 0;
    return !input.buffer.empty();
  }

  void push(std::size_t input) {
    heap_.push_back(input);
    std::push_heap(heap_.begin(), heap_.end(), Later{&inputs_});
  }

  std::size_t batch_;
  std::vector<Input> inputs_;
  std::vector<std::size_t>
      heap_;  ///< inputs that are not empty, the one with the least front first
};

}  // namespace stream_recon
