// Lines and words of a text input, counted for messages.
//
// Guarantees: keeps no bytes of its own, so a reader may go on with the ByteSource in between, as
// formats with a text header and a binary body need. A line end is "\n" or "\r\n"; a lone "\r" is
// refused wherever it is met. Memory: none beyond the source's window, which a line or word must
// fit. Thread rule: one reader.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "io/byte_source.h"

namespace stream_recon {

class TextReader {
 public:
  /// `lines_before`: lines of `source` that were taken already.
  explicit TextReader(ByteSource& source, std::uint64_t lines_before = 0)
      : source_(source), line_(lines_before), line_ends_(lines_before) {}

  /// Takes the next line, without its end; false at the end of the input. The view holds until
  /// the next call. \throw InputError a line longer than the window
  bool next_line(std::string_view& line);
  /// Takes a line of any length, unseen; false at the end of the input.
  bool skip_line();
  /// Takes the next word between blanks and line ends; empty at the end of the input.
  /// \throw InputError a word longer than the window
  std::string_view next_word();

  /// Whether a line end or a blank stood behind what was taken last, not the end of the input.
  bool terminated() const { return terminated_; }
  /// The line what was taken last stands in, from 1.
  std::uint64_t line() const { return line_; }

  /// \throw InputError always: "name: line N: what".
  [[noreturn]] void fail(const std::string& what) const;

 private:
  ByteSource& source_;
  std::uint64_t line_;
  std::uint64_t line_ends_;
  bool terminated_ = true;
};

}  // namespace stream_recon
