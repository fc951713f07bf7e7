#include "engine/order/run_merger.h"

#include <algorithm>

namespace stream_recon {

RunMerger::RunMerger(const ScratchDirectory& scratch, const std::vector<std::string>& runs)
    : runs_(runs.size()) {
  for (std::size_t i = 0; i < runs.size(); ++i) {
    runs_[i].reader = std::make_unique<ScratchReader<SortRecord>>(scratch, runs[i]);
    if (runs_[i].refill()) push(i);
  }
}

bool RunMerger::next(SortRecord& record) {
  if (heap_.empty()) return false;
  const auto later = [this](std::size_t a, std::size_t b) {
    return runs_[b].front() < runs_[a].front();
  };
  std::pop_heap(heap_.begin(), heap_.end(), later);
  const std::size_t winner = heap_.back();
  heap_.pop_back();
  Run& run = runs_[winner];
  record = run.front();
  ++run.next;
  if (run.next < run.buffer.size() || run.refill()) push(winner);
  return true;
}

void RunMerger::push(std::size_t run) {
  const auto later = [this](std::size_t a, std::size_t b) {
    return runs_[b].front() < runs_[a].front();
  };
  heap_.push_back(run);
  std::push_heap(heap_.begin(), heap_.end(), later);
}

bool RunMerger::Run::refill() {
  buffer.resize(kRunBlock / sizeof(SortRecord));
  buffer.resize(reader->read(buffer));
  next = 0;
  return !buffer.empty();
}

}  // namespace stream_recon
