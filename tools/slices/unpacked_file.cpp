#include "tools/slices/unpacked_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <new>

#include "io/error.h"

namespace stream_recon {
namespace {

constexpr std::size_t kPackedBytes = std::size_t{1} << 16;
constexpr std::size_t kSkipBytes = std::size_t{1} << 16;
constexpr int kZlibOrGzip = 15 + 32;  // largest window, kind by the first bytes

File open_input(const std::string& path) {
  length_of_file(path);
  return File::open(path);
}

Bytef* zlib_bytes(std::byte* bytes) {
  return reinterpret_cast<Bytef*>(bytes);
}

}  // namespace

std::uint64_t length_of_file(const std::string& path) {
  std::error_code error;
  const std::uint64_t length = std::filesystem::file_size(path, error);
  if (error) throw InputError(fmt::format("{}: no such file; check the name", path));
  return length;
}

Packing packing_of(const std::string& path) {
  std::array<std::byte, 2> first{};
  open_input(path).read(first);
  return first == std::array{std::byte{0x1f}, std::byte{0x8b}} ? Packing::kZlib : Packing::kNone;
}

UnpackedFile::UnpackedFile(const std::string& path, Packing packing, std::uint64_t start)
    : path_(path), packing_(packing), file_(open_input(path)), start_(start) {
  if (packing == Packing::kNone) return;
  std::array<std::byte, 4096> before;
  for (std::uint64_t left = start; left > 0;) {
    const std::size_t n = file_.read(std::span(before).first(std::min(left, before.size())));
    if (n == 0) break;
    left -= n;
  }
  packed_.resize(kPackedBytes);
  if (inflateInit2(&zlib_, kZlibOrGzip) != Z_OK) throw std::bad_alloc();
}

UnpackedFile::~UnpackedFile() {
  if (packing_ == Packing::kZlib) inflateEnd(&zlib_);
}

std::size_t UnpackedFile::read(std::span<std::byte> out) {
  std::size_t count = 0;
  if (packing_ == Packing::kNone) {
    const std::uint64_t at = start_ + position_;
    const std::uint64_t size = file_.size();
    count = std::min<std::uint64_t>(out.size(), size > at ? size - at : 0);
    file_.read_at(at, out.first(count));
  } else {
    while (count < out.size()) {
      const std::size_t n = unpack(out.subspan(count));
      if (n == 0) break;
      count += n;
    }
  }
  position_ += count;
  return count;
}

std::uint64_t UnpackedFile::skip(std::uint64_t count) {
  if (packing_ == Packing::kNone) {
    position_ += count;
    return count;
  }
  std::vector<std::byte> unwanted(std::min<std::uint64_t>(count, kSkipBytes));
  std::uint64_t done = 0;
  while (done < count) {
    const std::size_t part = std::min<std::uint64_t>(count - done, unwanted.size());
    const std::size_t n = read(std::span(unwanted).first(part));
    done += n;
    if (n < part) break;
  }
  return done;
}

void UnpackedFile::finish() {
  if (packing_ == Packing::kNone) return;
  std::vector<std::byte> unwanted(kSkipBytes);
  while (read(unwanted) > 0) {
  }
  if (has_ended_) return;
  throw InputError(fmt::format("{}: ends within its packed data; copy the file again", path_));
}

bool UnpackedFile::refill() {
  const std::size_t n = file_.read(packed_);
  zlib_.next_in = zlib_bytes(packed_.data());
  zlib_.avail_in = static_cast<uInt>(n);
  return n > 0;
}

/// Some bytes, at least one unless the packed data or the file has ended.
std::size_t UnpackedFile::unpack(std::span<std::byte> out) {
  constexpr std::size_t kMost = std::size_t{1} << 30;
  const auto room = static_cast<uInt>(std::min(out.size(), kMost));
  zlib_.next_out = zlib_bytes(out.data());
  zlib_.avail_out = room;
  while (zlib_.avail_out == room) {
    if (has_ended_ && !begins_next_member()) break;
    if (zlib_.avail_in == 0 && !refill()) break;
    const int result = inflate(&zlib_, Z_NO_FLUSH);
    if (result == Z_STREAM_END) {
      has_ended_ = true;
    } else if (result != Z_OK && result != Z_BUF_ERROR) {
      throw InputError(fmt::format("{}: damaged after {} unpacked bytes; copy the file again",
                                   path_, position_ + room - zlib_.avail_out));
    }
  }
  return room - zlib_.avail_out;
}

/// Only gzip's first byte can follow; anything else behind the end is no data.
bool UnpackedFile::begins_next_member() {
  if (zlib_.avail_in == 0 && !refill()) return false;
  if (*zlib_.next_in != 0x1f) return false;
  inflateReset(&zlib_);
  has_ended_ = false;
  return true;
}

}  // namespace stream_recon
