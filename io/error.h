// The errors that end a run while bytes are read or written. Messages say what, where (file, byte
// or line) and what to do, on one line.
#pragma once

#include <stdexcept>
#include <string>

namespace stream_recon {

/// The input is not what it claims to be: exit code 65.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The system refused to read or write, or a file of ours is damaged: exit code 74.
class IoError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace stream_recon
