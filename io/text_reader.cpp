#include "io/text_reader.h"

#include <cstring>

#include "io/error.h"

namespace stream_recon {
namespace {

constexpr bool is_space(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}

}  // namespace

bool TextReader::next_line(std::string_view& line) {
  std::string_view ready = source_.peek(1);
  if (ready.empty()) return false;
  line_ = line_ends_ + 1;
  const void* found = std::memchr(ready.data(), '\n', ready.size());
  if (found == nullptr) {
    ready = source_.peek(ByteSource::kWindow);
    found = std::memchr(ready.data(), '\n', ready.size());
    if (found == nullptr && ready.size() >= ByteSource::kWindow) {
      fail("the line is longer than " + std::to_string(ByteSource::kWindow) +
           " bytes; this is no text of points, check the input format");
    }
  }
  terminated_ = found != nullptr;
  const std::size_t length =
      terminated_ ? static_cast<std::size_t>(static_cast<const char*>(found) - ready.data())
                  : ready.size();
  source_.consume(length + (terminated_ ? 1 : 0));
  line_ends_ += terminated_ ? 1 : 0;
  line = ready.substr(0, length);
  if (terminated_ && line.ends_with('\r')) line.remove_suffix(1);
  if (!line.empty() && std::memchr(line.data(), '\r', line.size()) != nullptr) {
    fail("a carriage return without a line feed; convert the line ends, e.g. with mac2unix");
  }
  return true;
}

bool TextReader::skip_line() {
  bool any = false;
  for (;;) {
    const std::string_view ready = source_.peek(1);
    if (ready.empty()) {
      terminated_ = false;
      return any;
    }
    any = true;
    line_ = line_ends_ + 1;
    const void* found = std::memchr(ready.data(), '\n', ready.size());
    if (found != nullptr) {
      source_.consume(static_cast<std::size_t>(static_cast<const char*>(found) - ready.data()) + 1);
      ++line_ends_;
      terminated_ = true;
      return true;
    }
    source_.consume(ready.size());
  }
}

std::string_view TextReader::next_word() {
  std::string_view ready = source_.peek(1);
  while (!ready.empty() && is_space(ready.front())) {
    std::size_t blank = 0;
    for (; blank < ready.size() && is_space(ready[blank]); ++blank) {
      if (ready[blank] == '\n') ++line_ends_;
    }
    source_.consume(blank);
    ready = source_.peek(1);
  }
  line_ = line_ends_ + 1;
  std::size_t length = 0;
  for (;;) {
    while (length < ready.size() && !is_space(ready[length])) ++length;
    if (length < ready.size()) break;
    const std::size_t before = ready.size();
    if (before >= ByteSource::kWindow) {
      fail("the word is longer than " + std::to_string(ByteSource::kWindow) +
           " bytes; this is no text of numbers, check the input format");
    }
    ready = source_.peek(before + 1);
    if (ready.size() == before) break;
  }
  terminated_ = length < ready.size();
  source_.consume(length);
  return ready.substr(0, length);
}

void TextReader::fail(const std::string& what) const {
  throw InputError(source_.name() + ": line " + std::to_string(line_) + ": " + what);
}

}  // namespace stream_recon
