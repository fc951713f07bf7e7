#include "tools/slices/tiff_directories.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <unordered_set>

#include "io/error.h"
#include "io/file.h"
#include "io/scalar_type.h"
#include "tools/slices/slice_image.h"
#include "tools/slices/unpacked_file.h"

namespace stream_recon {
namespace {

class TiffChain {
 public:
  explicit TiffChain(const std::string& path)
      : path_(path), length_(length_of_file(path)), file_(File::open(path)) {
    std::array<char, 4> magic{};
    read(0, magic);
    order_ = magic[0] == 'I' ? std::endian::little : std::endian::big;
    is_big_ = magic[2] == '+' || magic[3] == '+';
  }

  std::uint64_t first() { return is_big_ ? number<std::uint64_t>(8) : number<std::uint32_t>(4); }

  std::uint64_t next(std::uint64_t directory) {
    if (is_big_) {
      const auto entries = number<std::uint64_t>(directory);
      if (entries > length_ / 20) fail(directory);
      return number<std::uint64_t>(directory + 8 + entries * 20);
    }
    const auto entries = number<std::uint16_t>(directory);
    return number<std::uint32_t>(directory + 2 + std::uint64_t{entries} * 12);
  }

 private:
  template <typename Number>
  Number number(std::uint64_t at) {
    std::array<char, sizeof(Number)> bytes{};
    read(at, bytes);
    return load_scalar<Number>(bytes.data(), order_);
  }

  void read(std::uint64_t at, std::span<char> out) {
    if (at > length_ || out.size() > length_ - at) fail(at);
    file_.read_at(at, std::as_writable_bytes(out));
  }

  [[noreturn]] void fail(std::uint64_t at) const {
    refuse_damaged_image(
        path_, fmt::format("a page is described at byte {}, but the file has {}", at, length_));
  }

  std::string path_;
  std::uint64_t length_;
  File file_;
  std::endian order_ = std::endian::little;
  bool is_big_ = false;
};

}  // namespace

std::vector<std::uint64_t> tiff_directories(const std::string& path) {
  TiffChain chain(path);
  std::vector<std::uint64_t> directories;
  std::unordered_set<std::uint64_t> seen;
  for (std::uint64_t at = chain.first(); at != 0; at = chain.next(at)) {
    if (!seen.insert(at).second) refuse_damaged_image(path, "its pages form a circle");
    directories.push_back(at);
  }
  if (directories.empty()) refuse_damaged_image(path, "it has no page");
  return directories;
}

}  // namespace stream_recon
