// A lock on a folder that lives as long as its holder, however that one ends.
//
// Guarantees: of all processes, and of all objects in one, a folder has one lock at a time; the
// system lets it go when the process dies. File systems without locks make every folder look
// locked. Thread rule: one thread. Memory: a file descriptor.
#pragma once

#include <optional>
#include <string>

namespace stream_recon {

class FolderLock {
 public:
  /// Nothing where another holds it or `path` is no folder.
  static std::optional<FolderLock> try_take(const std::string& path);

  FolderLock(FolderLock&& other) noexcept;
  FolderLock& operator=(FolderLock&& other) noexcept;
  ~FolderLock();

 private:
  explicit FolderLock(int descriptor) : descriptor_(descriptor) {}

  int descriptor_;
};

}  // namespace stream_recon
