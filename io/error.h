// The errors that end a run while bytes are read or written. Messages say what, where (file, byte
// or line) and what to do, on one line.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

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

/// Says that `what` (for example "create", "write 4096 bytes at byte 0 of") could not be done to
/// `path`, why (the text of `error_number`), and what to do about it.
/// \throw IoError always
[[noreturn]] void throw_system_error(std::string_view what, std::string_view path,
                                     int error_number);

}  // namespace stream_recon
