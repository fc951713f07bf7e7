// Where a single-file writer puts its bytes: a file that appears when it is complete, or standard
// output.
#pragma once

#include <optional>
#include <string>

#include "io/atomic_output.h"
#include "io/file.h"

namespace stream_recon {

class OutputTarget {
 public:
  /// "-" is standard output. \throw IoError cannot create
  explicit OutputTarget(const std::string& path) {
    if (path == "-") {
      stream_ = File::standard_output();
    } else {
      output_.emplace(path);
    }
  }

  File& file() { return output_ ? output_->file() : stream_; }
  /// Forces what was written to the device. \throw IoError
  void prepare() {
    if (output_) output_->prepare();
  }
  /// \throw IoError
  void commit() {
    if (output_) output_->commit();
  }

 private:
  std::optional<AtomicOutput> output_;
  File stream_;
};

}  // namespace stream_recon
