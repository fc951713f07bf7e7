// Renames of which all happen or none.
//
// Guarantees: unless commit() was called, the destructor undoes what was done, last first, as far
// as the system lets it. Not atomic for a reader that looks in between.
#pragma once

#include <string>
#include <vector>

namespace stream_recon {

class RenameSequence {
 public:
  RenameSequence() = default;
  ~RenameSequence();
  RenameSequence(const RenameSequence&) = delete;
  RenameSequence& operator=(const RenameSequence&) = delete;

  /// \throw IoError
  void rename(const std::string& from, const std::string& to);
  void commit() { done_.clear(); }

 private:
  struct Step {
    std::string from;
    std::string to;
  };
  std::vector<Step> done_;
};

}  // namespace stream_recon
