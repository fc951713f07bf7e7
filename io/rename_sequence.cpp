#include "io/rename_sequence.h"

#include <cstdio>
#include <utility>

#include "io/folder.h"

namespace stream_recon {

RenameSequence::~RenameSequence() {
  for (; !done_.empty(); done_.pop_back()) {
    std::rename(done_.back().to.c_str(), done_.back().from.c_str());
  }
}

void RenameSequence::rename(const std::string& from, const std::string& to) {
  done_.reserve(done_.size() + 1);  // so that nothing can fail once the name has changed
  Step step{from, to};
  rename_path(from, to);
  done_.push_back(std::move(step));
}

}  // namespace stream_recon
