// Arrays stored as characters: base64 and plain numbers.
#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <string>

#include "io/number_text.h"
#include "io/vtp_stream.h"

namespace stream_recon {
namespace {

constexpr bool is_space(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}

constexpr unsigned char kPadding = 64;
constexpr unsigned char kInvalid = 65;

constexpr std::array<unsigned char, 256> base64_values() {
  std::array<unsigned char, 256> values{};
  values.fill(kInvalid);
  constexpr std::string_view kAlphabet =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/=";
  for (std::size_t i = 0; i < kAlphabet.size(); ++i) {
    values[static_cast<unsigned char>(kAlphabet[i])] = static_cast<unsigned char>(i);
  }
  return values;
}

constexpr std::array<unsigned char, 256> kBase64 = base64_values();

class Base64Stream : public VtpStream {
 public:
  Base64Stream(VtpText& text, const ByteSource& source) : text_(text), source_(source) {}

  std::size_t read(std::span<char> out) override {
    std::size_t done = 0;
    while (done < out.size()) {
      if (next_ == ready_ && !decode_four()) break;
      out[done++] = bytes_[next_++];
    }
    return done;
  }

 private:
  /// The next character that is no white space, as its value; kInvalid at the end.
  unsigned char take() {
    for (;;) {
      const std::string_view piece = text_.peek();
      if (piece.empty()) return kInvalid;
      std::size_t at = 0;
      while (at < piece.size() && is_space(piece[at])) ++at;
      const bool found = at < piece.size();
      const unsigned char value = found ? kBase64[static_cast<unsigned char>(piece[at])] : kInvalid;
      text_.consume(at + (found ? 1 : 0));
      if (!found) continue;
      if (value == kInvalid) source_.fail("a character that is not base64; the file is damaged");
      return value;
    }
  }

  bool decode_four() {
    std::array<unsigned, 4> values{};
    for (std::size_t i = 0; i < 4; ++i) {
      values[i] = take();
      if (values[i] != kInvalid) continue;
      if (i == 0) return false;
      source_.fail("base64 data ends inside a group; the file is cut short or damaged");
    }
    const std::size_t padding = (values[3] == kPadding ? 1 : 0) + (values[2] == kPadding ? 1 : 0);
    if (values[0] == kPadding || values[1] == kPadding ||
        (values[2] == kPadding && values[3] != kPadding)) {
      source_.fail("misplaced base64 padding; the file is damaged");
    }
    const unsigned group =
        values[0] << 18 | values[1] << 12 | (values[2] & 63) << 6 | (values[3] & 63);
    bytes_ = {static_cast<char>(group >> 16), static_cast<char>(group >> 8),
              static_cast<char>(group)};
    next_ = 0;
    ready_ = 3 - padding;
    return true;
  }

  VtpText& text_;
  const ByteSource& source_;
  std::array<char, 3> bytes_{};
  std::size_t next_ = 0;
  std::size_t ready_ = 0;
};

class NumberStream : public VtpStream {
 public:
  NumberStream(VtpText& text, ScalarType type, const ByteSource& source)
      : text_(text), source_(source), type_(type), size_(scalar_size(type)) {}

  /// Whole values only: `out` must hold a multiple of their size.
  std::size_t read(std::span<char> out) override {
    std::size_t done = 0;
    while (out.size() - done >= size_ && take_word()) {
      store(out.data() + done);
      done += size_;
    }
    return done;
  }

 private:
  bool take_word() {
    constexpr std::size_t kLongest = 1024;
    word_.clear();
    for (std::string_view piece = text_.peek(); !piece.empty(); piece = text_.peek()) {
      std::size_t begin = 0;
      while (word_.empty() && begin < piece.size() && is_space(piece[begin])) ++begin;
      std::size_t end = begin;
      while (end < piece.size() && !is_space(piece[end])) ++end;
      word_.append(piece.substr(begin, end - begin));
      text_.consume(end);
      if (word_.size() > kLongest) source_.fail("a number of endless length; the file is damaged");
      if (end < piece.size()) break;
    }
    return !word_.empty();
  }

  template <typename T>
  void store_integer(char* out) {
    T value{};
    const char* end = word_.data() + word_.size();
    const auto [stop, error] = std::from_chars(word_.data(), end, value);
    if (error != std::errc{} || stop != end) fail_word();
    std::memcpy(out, &value, sizeof(T));
  }

  template <typename T>
  void store_real(char* out, std::optional<double> parsed) {
    if (!parsed) fail_word();
    const T value = static_cast<T>(*parsed);
    std::memcpy(out, &value, sizeof(T));
  }

  void store(char* out) {
    switch (type_) {
      case ScalarType::kInt8:
        return store_integer<std::int8_t>(out);
      case ScalarType::kUint8:
        return store_integer<std::uint8_t>(out);
      case ScalarType::kInt16:
        return store_integer<std::int16_t>(out);
      case ScalarType::kUint16:
        return store_integer<std::uint16_t>(out);
      case ScalarType::kInt32:
        return store_integer<std::int32_t>(out);
      case ScalarType::kUint32:
        return store_integer<std::uint32_t>(out);
      case ScalarType::kInt64:
        return store_integer<std::int64_t>(out);
      case ScalarType::kUint64:
        return store_integer<std::uint64_t>(out);
      case ScalarType::kFloat32:
        return store_real<float>(out, whole_float(word_));
      case ScalarType::kFloat64:
        return store_real<double>(out, whole_double(word_));
    }
  }

  [[noreturn]] void fail_word() const {
    source_.fail(quote_text(word_) + " does not fit the type of its array; the file is damaged");
  }

  VtpText& text_;
  const ByteSource& source_;
  ScalarType type_;
  std::size_t size_;
  std::string word_;
};

}  // namespace

std::unique_ptr<VtpStream> make_base64_stream(VtpText& text, const ByteSource& source) {
  return std::make_unique<Base64Stream>(text, source);
}

std::unique_ptr<VtpStream> make_number_stream(VtpText& text, ScalarType type,
                                              const ByteSource& source) {
  return std::make_unique<NumberStream>(text, type, source);
}

}  // namespace stream_recon
