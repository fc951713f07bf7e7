// Parts of a file that grow side by side in scratch files until they can be joined.
//
// Guarantees: each part comes out in the order it was appended; its scratch file is removed as soon
// as it has been copied, or when this object goes. Memory: 1 MiB while copying, no buffer else, so
// append large pieces. Thread rule: one thread. Cost: every byte is written twice and read once.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "io/file.h"
#include "io/scratch_directory.h"

namespace stream_recon {

class SpooledParts {
 public:
  /// \throw IoError cannot create
  SpooledParts(ScratchDirectory& scratch, std::size_t count);
  ~SpooledParts();
  SpooledParts(const SpooledParts&) = delete;
  SpooledParts& operator=(const SpooledParts&) = delete;

  /// \throw IoError
  void append(std::size_t part, std::span<const std::byte> bytes);
  /// Writes a part to `target` and removes it. \throw IoError
  void move_to(std::size_t part, File& target);

 private:
  struct Part {
    std::string name;
    File file;
  };

  ScratchDirectory& scratch_;
  std::vector<Part> parts_;
};

}  // namespace stream_recon
