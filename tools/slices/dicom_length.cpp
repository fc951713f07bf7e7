#include "tools/slices/dicom_length.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <string_view>

#include "io/error.h"
#include "io/file.h"
#include "io/scalar_type.h"
#include "tools/slices/unpacked_file.h"

namespace stream_recon {
namespace {

constexpr std::uint64_t kFirstElement = 132;
constexpr std::uint32_t kUndefined = 0xffffffff;
constexpr std::uint32_t kTransferSyntax = 0x00020010;
constexpr std::uint32_t kItem = 0xfffee000;
constexpr std::uint32_t kItemEnd = 0xfffee00d;
constexpr std::uint32_t kSequenceEnd = 0xfffee0dd;
constexpr int kDeepest = 32;

struct NotJudged {};

class DicomWalk {
 public:
  explicit DicomWalk(const std::string& path)
      : path_(path), length_(length_of_file(path)), file_(File::open(path)) {}

  void run() {
    if (length_ < kFirstElement || bytes<4>(kFirstElement - 4) != "DICM") return;
    walk_file_information();
    while (at_ < length_) step_over_element(0);
  }

 private:
  template <std::size_t n>
  std::string bytes(std::uint64_t at) {
    std::string text(n, '\0');
    if (n > length_ - at) fail(at + n);
    file_.read_at(at, std::as_writable_bytes(std::span(text)));
    return text;
  }
  template <typename Number>
  Number number() {
    const std::string raw = bytes<sizeof(Number)>(at_);
    at_ += sizeof(Number);
    return load_scalar<Number>(raw.data(), order_);
  }
  std::uint32_t tag() {
    const std::uint32_t group = number<std::uint16_t>();
    return group << 16 | number<std::uint16_t>();
  }
  void step(std::uint64_t count) {
    if (count > length_ - at_) fail(at_ + count);
    at_ += count;
  }
  [[noreturn]] void fail(std::uint64_t end) const {
    throw InputError(fmt::format(
        "{}: {} bytes of at least {}, a truncated DICOM file; copy it again", path_, length_, end));
  }

  /// Group 2 is explicit and little endian; it says how the rest is written.
  void walk_file_information() {
    at_ = kFirstElement;
    std::string syntax;
    while (length_ - at_ < 2 || bytes<2>(at_) == std::string_view("\2\0", 2)) {
      const std::uint32_t name = tag();
      const std::uint32_t size = explicit_length();
      if (name == kTransferSyntax && size <= 64) {
        syntax = bytes<64>(at_).substr(0, size);
        while (!syntax.empty() && syntax.back() == '\0') syntax.pop_back();
      }
      step(size);
    }
    if (syntax.empty() || syntax == "1.2.840.10008.1.2.1.99") throw NotJudged();
    is_implicit_ = syntax == "1.2.840.10008.1.2";
    if (syntax == "1.2.840.10008.1.2.2") order_ = std::endian::big;
  }

  std::uint32_t explicit_length() {
    const std::string type = bytes<2>(at_);
    for (const char c : type)
      if (c < 'A' || c > 'Z') throw NotJudged();
    at_ += 2;
    static constexpr std::string_view kLong = "OB OD OF OL OV OW SQ SV UC UN UR UT UV";
    if (kLong.find(type) == std::string_view::npos) return number<std::uint16_t>();
    step(2);
    const auto size = number<std::uint32_t>();
    if (type == "UN" && size == kUndefined) throw NotJudged();
    return size;
  }

  std::uint32_t step_over_element(int depth) {
    const std::uint32_t name = tag();
    const bool is_mark = name >> 16 == 0xfffe;
    const std::uint32_t size =
        is_mark || is_implicit_ ? number<std::uint32_t>() : explicit_length();
    if (size != kUndefined) {
      step(size);
    } else if (is_mark || depth > kDeepest) {
      throw NotJudged();
    } else {
      step_over_items(depth + 1);
    }
    return name;
  }

  /// Up to the end of a sequence, or of the fragments of packed voxels.
  void step_over_items(int depth) {
    for (;;) {
      const std::uint32_t name = tag();
      const auto size = number<std::uint32_t>();
      if (name == kSequenceEnd) return;
      if (name != kItem) throw NotJudged();
      if (size != kUndefined) {
        step(size);
        continue;
      }
      while (step_over_element(depth) != kItemEnd) {
      }
    }
  }

  std::string path_;
  std::uint64_t length_;
  File file_;
  std::uint64_t at_ = 0;
  std::endian order_ = std::endian::little;
  bool is_implicit_ = false;
};

}  // namespace

void check_dicom_length(const std::string& path) {
  try {
    DicomWalk(path).run();
  } catch (const NotJudged&) {
    return;  // GDCM will
  }
}

}  // namespace stream_recon
