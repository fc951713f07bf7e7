// One file that appears under its name complete or not at all.
//
// Guarantees: until commit() returned, what stood under the name stays as it was; after it, the new
// bytes stand there and on the device. An object destroyed before that removes what it wrote, and
// remove_temporary_paths() does so on SIGINT.
// Thread rule: one thread. Cost: the new file lies beside the old one until commit().
#pragma once

#include <string>
#include <string_view>

#include "io/file.h"
#include "io/temporary_path.h"

namespace stream_recon {

class AtomicOutput {
 public:
  /// \throw IoError cannot create beside `path`, or `path` is a folder
  explicit AtomicOutput(std::string path);

  File& file() { return file_; }

  /// No more bytes: forces them to the device. \throw IoError
  void prepare();
  /// Puts the bytes under the name, prepared if they are not yet. \throw IoError
  void commit();

 private:
  std::string path_;
  File file_;
  TemporaryPath temporary_;
};

/// A new file under a temporary name, to take the name `path` later. \throw IoError cannot create
/// beside `path`, or what stands there is no file
File create_beside(const std::string& path);

/// Puts all of a small file under `path`, complete or not at all; "-" is standard output.
/// \throw IoError
void write_output(const std::string& path, std::string_view bytes);

}  // namespace stream_recon
