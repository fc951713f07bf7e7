// The folder for files that live as long as the run: spools, sorted runs, parts of outputs.
//
// Guarantees: the folder is new, and gone with its files when the object goes, also while an error
// unwinds; remove_temporary_paths() (io/temporary_path.h) removes it on SIGINT. The bytes of its
// files are counted, their peak kept, and the limit is never exceeded.
// Thread rule: thread-safe; a file handed out belongs to its taker. Memory: none to speak of.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <string>

#include "io/file.h"
#include "io/storage_meter.h"
#include "io/temporary_path.h"

namespace stream_recon {

struct ScratchOptions {
  /// An existing folder; the scratch folder is made in it.
  std::string parent;
  /// Bytes that all files together may take.
  std::uint64_t limit_bytes = std::numeric_limits<std::uint64_t>::max();
};

class ScratchDirectory {
 public:
  /// \throw IoError cannot create
  explicit ScratchDirectory(const ScratchOptions& options);

  /// A new file for writing and reading. \throw IoError, std::invalid_argument if `name` has a '/'
  File create(const std::string& name);
  /// An existing file for reading. \throw IoError
  File open(const std::string& name) const;
  /// Removes a file, if it is there, and gives back its bytes.
  void remove(const std::string& name);

  const std::string& path() const { return folder_.path(); }
  std::uint64_t used_bytes() const { return meter_->used(); }
  std::uint64_t peak_bytes() const { return meter_->peak(); }

 private:
  std::string path_of(const std::string& name) const;

  TemporaryPath folder_;
  std::shared_ptr<StorageMeter> meter_;
};

/// Where scratch goes unless told otherwise: beside the output; for standard output ("-") to
/// $TMPDIR or else /var/tmp, which unlike /tmp is never held in memory.
std::string default_scratch_parent(const std::string& output_path);

}  // namespace stream_recon
