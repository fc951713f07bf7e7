// The folder for files that live as long as the run: spools, sorted runs, parts of outputs.
//
// Guarantees: the folder is locked while the object lives. It is gone with its files when the
// object goes, also while an error unwinds, and remove_temporary_paths() (io/temporary_path.h)
// removes it on SIGINT; unless keep() was called: then it stays, for a later run to adopt, until
// discard(). The bytes of its files are counted, their peak kept, and the limit is never exceeded.
// Thread rule: thread-safe but for keep() and discard(); a file handed out belongs to its taker.
// Memory: none to speak of.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/file.h"
#include "io/folder_lock.h"
#include "io/storage_meter.h"
#include "io/temporary_path.h"

namespace stream_recon {

struct ScratchOptions {
  /// An existing folder; the scratch folder is made in it.
  std::string parent;
  /// Bytes that all files together may take.
  std::uint64_t limit_bytes = std::numeric_limits<std::uint64_t>::max();
};

/// A scratch folder whose run is no more.
struct AbandonedScratch {
  std::string path;
  FolderLock lock;
};

class ScratchDirectory {
 public:
  /// \throw IoError cannot create
  explicit ScratchDirectory(const ScratchOptions& options);
  /// Takes over a folder in options.parent, under a name of this process, and keeps it.
  /// \throw IoError
  ScratchDirectory(AbandonedScratch abandoned, const ScratchOptions& options);
  ~ScratchDirectory();
  ScratchDirectory(const ScratchDirectory&) = delete;
  ScratchDirectory& operator=(const ScratchDirectory&) = delete;

  /// A new file for writing and reading. \throw IoError, std::invalid_argument if `name` has a '/'
  File create(const std::string& name);
  /// An existing file for reading. \throw IoError
  File open(const std::string& name) const;
  /// Puts a file under another name, in one step; none of that name may exist. \throw IoError
  void rename(const std::string& from, const std::string& to);
  /// Makes `text` the content of a file, old or new, in one step. \throw IoError
  void replace(const std::string& name, std::string_view text);
  /// Removes a file, if it is there, and gives back its bytes.
  void remove(const std::string& name);
  bool has(const std::string& name) const;
  /// Names of the files, sorted. \throw IoError
  std::vector<std::string> names() const;

  /// From now on the folder outlives the object and signals.
  void keep() noexcept;
  /// Removes the folder when the object goes, kept or not.
  void discard() noexcept { is_kept_ = false; }

  const std::string& path() const { return path_; }
  std::uint64_t used_bytes() const { return meter_->used(); }
  std::uint64_t peak_bytes() const { return meter_->peak(); }

 private:
  std::string path_of(const std::string& name) const;

  std::string path_;
  std::optional<FolderLock> lock_;  ///< none where the file system has no locks
  std::optional<TemporaryPath> temporary_;
  bool is_kept_ = false;
  std::shared_ptr<StorageMeter> meter_;
};

/// Scratch folders in `parent`, of runs alive or dead, sorted. \throw IoError
std::vector<std::string> scratch_folders(const std::string& parent);

/// Where scratch goes unless told otherwise: beside the output; for standard output ("-") to
/// $TMPDIR or else /var/tmp, which unlike /tmp is never held in memory.
std::string default_scratch_parent(const std::string& output_path);

}  // namespace stream_recon
