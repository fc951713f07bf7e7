#include "io/byte_source.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>

#include "io/error.h"

namespace stream_recon {
namespace {

std::string reason(int error) {
  return std::generic_category().message(error);
}

}  // namespace

ByteSource::ByteSource(const std::string& path)
    : name_(path == "-" ? "standard input" : path), window_(new char[kWindow]) {
  const bool standard = path == "-";
  const int descriptor = standard ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) {
    throw IoError(name_ + ": cannot open: " + reason(errno) + "; check the path and its rights");
  }
  struct stat status {};
  const bool known = ::fstat(descriptor, &status) == 0;
  if (known && S_ISDIR(status.st_mode)) {
    if (!standard) ::close(descriptor);
    throw IoError(name_ + ": cannot read: it is a directory; name a file");
  }
  if (known && S_ISREG(status.st_mode) && !standard) {
    size_ = static_cast<std::uint64_t>(status.st_size);
  }
  descriptor_ = descriptor;
}

ByteSource::~ByteSource() {
  if (descriptor_ > STDIN_FILENO) ::close(descriptor_);
}

std::size_t ByteSource::read_some(char* out, std::size_t size) {
  if (at_end_) return 0;
  for (;;) {
    const ssize_t count = ::read(descriptor_, out, size);
    if (count > 0) return static_cast<std::size_t>(count);
    if (count == 0) {
      at_end_ = true;
      return 0;
    }
    if (errno != EINTR) {
      throw IoError(name_ + ": byte " + std::to_string(window_offset_ + end_) +
                    ": cannot read: " + reason(errno) + "; check the device or the pipe");
    }
  }
}

void ByteSource::fill(std::size_t least) {
  std::memmove(window_.get(), window_.get() + begin_, end_ - begin_);
  window_offset_ += begin_;
  end_ -= begin_;
  begin_ = 0;
  least = std::min(least, kWindow);
  while (end_ < least) {
    const std::size_t count = read_some(window_.get() + end_, kWindow - end_);
    if (count == 0) return;
    end_ += count;
  }
}

std::size_t ByteSource::read(std::span<char> out) {
  std::size_t done = 0;
  while (done < out.size()) {
    const std::string_view ready = peek(1);
    if (ready.empty()) break;
    const std::size_t count = std::min(ready.size(), out.size() - done);
    std::memcpy(out.data() + done, ready.data(), count);
    consume(count);
    done += count;
  }
  return done;
}

std::uint64_t ByteSource::skip(std::uint64_t count) {
  std::uint64_t done = 0;
  while (done < count) {
    const std::string_view ready = peek(1);
    if (ready.empty()) break;
    const auto step = static_cast<std::size_t>(std::min<std::uint64_t>(ready.size(), count - done));
    consume(step);
    done += step;
  }
  return done;
}

void ByteSource::fail_at(std::uint64_t byte, const std::string& what) const {
  throw InputError(name_ + ": byte " + std::to_string(byte) + ": " + what);
}

}  // namespace stream_recon
