// How the reader tests hand bytes over and see what became of them.
#pragma once

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "io/error.h"
#include "io/point_source.h"
#include "io_test_folder.h"

namespace stream_recon {

/// Points, or the message of the InputError that came instead of some of them.
struct Outcome {
  std::vector<Point3> points;
  std::string error;
  std::optional<std::uint64_t> announced;
};

/// Reads `path` to its end, `batch` points at a time. Any error but InputError is the caller's.
inline Outcome read_path(const std::string& path, InputFormat format, std::size_t batch = 1000) {
  Outcome outcome;
  try {
    const auto source = open_point_source(path, format);
    outcome.announced = source->announced_count();
    std::vector<Point3> buffer(batch);
    while (const std::size_t count = source->read(buffer)) {
      outcome.points.insert(outcome.points.end(), buffer.begin(),
                            buffer.begin() + static_cast<std::ptrdiff_t>(count));
    }
  } catch (const InputError& error) {
    outcome.error = error.what();
  }
  return outcome;
}

/// A file in memory, rewritten for each set of bytes: damage is tried a hundred thousand times.
class ByteFile {
 public:
  ByteFile() : descriptor_(::memfd_create("cloud", MFD_CLOEXEC)) {
    if (descriptor_ < 0) throw IoError("no file in memory");
  }
  ~ByteFile() { ::close(descriptor_); }
  ByteFile(const ByteFile&) = delete;
  ByteFile& operator=(const ByteFile&) = delete;

  std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

  void put(const std::string& bytes) const {
    if (::ftruncate(descriptor_, 0) != 0 ||
        ::pwrite(descriptor_, bytes.data(), bytes.size(), 0) != std::ssize(bytes)) {
      throw IoError("cannot write to memory");
    }
  }
  Outcome read(const std::string& bytes, InputFormat format, std::size_t batch = 1000) const {
    put(bytes);
    return read_path(path(), format, batch);
  }

 private:
  int descriptor_;
};

/// Feeds `bytes` through a pipe of the system in pieces of `piece` bytes.
class FedPipe {
 public:
  FedPipe(std::string bytes, std::size_t piece) : bytes_(std::move(bytes)) {
    std::signal(SIGPIPE, SIG_IGN);
    if (::pipe(ends_.data()) != 0) throw IoError("no pipe");
    writer_ = std::thread([this, piece] {
      for (std::size_t at = 0; at < bytes_.size(); at += piece) {
        const std::size_t count = std::min(piece, bytes_.size() - at);
        if (::write(ends_[1], bytes_.data() + at, count) < 0) break;
      }
      ::close(ends_[1]);
    });
  }
  ~FedPipe() {
    ::close(ends_[0]);
    writer_.join();
  }
  FedPipe(const FedPipe&) = delete;
  FedPipe& operator=(const FedPipe&) = delete;

  int descriptor() const { return ends_[0]; }
  std::string path() const { return "/dev/fd/" + std::to_string(ends_[0]); }

 private:
  std::string bytes_;
  std::array<int, 2> ends_{};
  std::thread writer_;
};

/// Bit for bit, so that NaN equals NaN and -0 is not 0.
inline bool same_bits(std::span<const Point3> a, std::span<const Point3> b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

/// The bytes of `values` in the given order, each as a T.
template <typename T>
std::string packed(std::span<const double> values, bool big_endian) {
  std::string bytes;
  for (const double value : values) {
    const T stored = static_cast<T>(value);
    char raw[sizeof(T)];
    std::memcpy(raw, &stored, sizeof(T));
    if (big_endian) std::reverse(raw, raw + sizeof(T));
    bytes.append(raw, sizeof(T));
  }
  return bytes;
}

}  // namespace stream_recon
