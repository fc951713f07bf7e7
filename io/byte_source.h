// Sequential bytes of a file or of standard input, through one fixed window; never seeks.
//
// Guarantees: bytes come in order, each once; offset() is the place of the next unread byte. The
// end of the input is reported as such, an error of the system as IoError: never one for the other.
// Memory: kWindow bytes, whatever the input. Cost: one copy from the system's cache.
// Thread rule: one reader.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace stream_recon {

class ByteSource {
 public:
  /// The longest run of bytes that can be looked at in one piece.
  static constexpr std::size_t kWindow = std::size_t{256} * 1024;

  /// Opens `path`, "-" for standard input. \throw IoError
  explicit ByteSource(const std::string& path);
  ~ByteSource();
  ByteSource(const ByteSource&) = delete;
  ByteSource& operator=(const ByteSource&) = delete;

  /// The path, or "standard input".
  const std::string& name() const { return name_; }
  std::uint64_t offset() const { return window_offset_ + begin_; }
  /// Size in bytes of a regular file; nothing for a pipe.
  std::optional<std::uint64_t> size() const { return size_; }

  /// The bytes in the window, at least `least` of them (<= kWindow) unless the input ends before.
  /// The view holds until the next call that is not const. \throw IoError
  std::string_view peek(std::size_t least) {
    if (end_ - begin_ < least) fill(least);
    return {window_.get() + begin_, end_ - begin_};
  }
  /// Steps over bytes that peek() has shown.
  void consume(std::size_t count) { begin_ += count; }

  /// Fills `out`; fewer bytes only at the end. \throw IoError
  std::size_t read(std::span<char> out);
  /// Steps over `count` bytes; the number stepped over is less only at the end. \throw IoError
  std::uint64_t skip(std::uint64_t count);

  /// \throw InputError always: "name: byte N: what".
  [[noreturn]] void fail(const std::string& what) const { fail_at(offset(), what); }
  [[noreturn]] void fail_at(std::uint64_t byte, const std::string& what) const;

 private:
  void fill(std::size_t least);
  std::size_t read_some(char* out, std::size_t size);

  std::string name_;
  int descriptor_ = -1;
  bool at_end_ = false;
  std::optional<std::uint64_t> size_;
  std::unique_ptr<char[]> window_;
  std::uint64_t window_offset_ = 0;  ///< offset of window_[0] in the input
  std::size_t begin_ = 0;            ///< first unread byte of the window
  std::size_t end_ = 0;              ///< end of the bytes in the window
};

}  // namespace stream_recon
