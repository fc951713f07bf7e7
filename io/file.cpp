#include "io/file.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cassert>
#include <cerrno>
#include <utility>

#include "io/error.h"
#include "io/fault_injection.h"

namespace stream_recon {
namespace {

std::atomic<std::uint64_t> total_read{0};
std::atomic<std::uint64_t> total_written{0};

std::string piece(const char* verb, std::size_t bytes, std::uint64_t offset) {
  return std::string(verb) + " " + std::to_string(bytes) + " bytes at byte " +
         std::to_string(offset) + " of";
}

/// Whether a call that failed should simply be made again.
bool should_retry(int descriptor, short direction) {
  if (errno == EINTR) return true;
  if (errno != EAGAIN && errno != EWOULDBLOCK) return false;
  pollfd waiting{descriptor, direction, 0};
  return ::poll(&waiting, 1, -1) >= 0 || errno == EINTR;
}

/// Calls `call(data, size, done)` until all of `data` is through, no progress is made, or an error
/// comes up; the number of bytes moved, and the error (0 for none).
template <class Byte, class Call>
std::pair<std::size_t, int> move_all(std::span<Byte> data, int descriptor, short direction,
                                     Call call) {
  std::size_t done = 0;
  while (done < data.size()) {
    const ssize_t moved = call(data.data() + done, data.size() - done, done);
    if (moved == 0) break;
    if (moved < 0 && !should_retry(descriptor, direction)) return {done, errno};
    if (moved > 0) done += static_cast<std::size_t>(moved);
  }
  return {done, 0};
}

template <class Call>
void write_all(std::span<const std::byte> data, int descriptor, const std::string& path,
               std::uint64_t offset, Call call) {
  const int injected = detail::injected_error(IoOperation::kWrite);
  const auto part = injected == 0 ? data : data.first(data.size() / 2);
  const auto [done, error] = move_all(part, descriptor, POLLOUT, call);
  total_written.fetch_add(done, std::memory_order_relaxed);
  if (injected == 0 && error == 0 && done == data.size()) return;
  if (injected != 0) detail::die_if_planned();
  const int reason = error != 0 ? error : injected != 0 ? injected : EIO;
  throw_system_error(piece("write", data.size(), offset), path, reason);
}

template <class Call>
std::size_t read_all(std::span<std::byte> out, int descriptor, const std::string& path,
                     std::uint64_t offset, Call call) {
  const int injected = detail::injected_error(IoOperation::kRead);
  const auto [done, error] = injected != 0 ? std::pair<std::size_t, int>{0, injected}
                                           : move_all(out, descriptor, POLLIN, call);
  total_read.fetch_add(done, std::memory_order_relaxed);
  if (error != 0) throw_system_error(piece("read", out.size(), offset), path, error);
  return done;
}

int open_checked(const std::string& path, int flags, const char* what) {
  int error = detail::injected_error(IoOperation::kOpen);
  int descriptor = -1;
  if (error == 0) {
    do {
      descriptor = ::open(path.c_str(), flags | O_CLOEXEC, 0666);
    } while (descriptor < 0 && errno == EINTR);
    error = descriptor < 0 ? errno : 0;
  }
  if (error != 0) throw_system_error(what, path, error);
  return descriptor;
}

}  // namespace

File::File(int descriptor, std::string path, std::shared_ptr<StorageMeter> meter)
    : descriptor_(descriptor), path_(std::move(path)), meter_(std::move(meter)) {}

File File::open(const std::string& path) {
  return {open_checked(path, O_RDONLY, "open"), path, nullptr};
}

File File::create(const std::string& path, std::shared_ptr<StorageMeter> meter) {
  return {open_checked(path, O_RDWR | O_CREAT | O_EXCL, "create"), path, std::move(meter)};
}

File File::standard_output() {
  return {STDOUT_FILENO, "standard output", nullptr};
}

File::File(File&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)),
      path_(std::move(other.path_)),
      meter_(std::move(other.meter_)),
      position_(std::exchange(other.position_, 0)),
      charged_(std::exchange(other.charged_, 0)) {}

File& File::operator=(File&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  std::swap(path_, other.path_);
  std::swap(meter_, other.meter_);
  std::swap(position_, other.position_);
  std::swap(charged_, other.charged_);
  return *this;
}

File::~File() {
  if (descriptor_ >= 0 && descriptor_ != STDOUT_FILENO) ::close(descriptor_);
}

std::size_t File::read(std::span<std::byte> out) {
  const std::size_t done =
      read_all(out, descriptor_, path_, position_,
               [this](std::byte* to, std::size_t n, auto) { return ::read(descriptor_, to, n); });
  position_ += done;
  return done;
}

void File::read_at(std::uint64_t offset, std::span<std::byte> out) const {
  const std::size_t done = read_all(
      out, descriptor_, path_, offset, [&](std::byte* to, std::size_t n, std::size_t before) {
        return ::pread(descriptor_, to, n, static_cast<off_t>(offset + before));
      });
  if (done == out.size()) return;
  throw IoError("cannot " + piece("read", out.size(), offset) + " " + path_ +
                ": the file ends at byte " + std::to_string(offset + done) +
                "; it was cut short, so make it again");
}

void File::write(std::span<const std::byte> data) {
  charge_up_to(position_ + data.size());
  write_all(
      data, descriptor_, path_, position_,
      [this](const std::byte* from, std::size_t n, auto) { return ::write(descriptor_, from, n); });
  position_ += data.size();
}

void File::write_at(std::uint64_t offset, std::span<const std::byte> data) {
  charge_up_to(offset + data.size());
  write_all(data, descriptor_, path_, offset,
            [&](const std::byte* from, std::size_t n, std::size_t before) {
              return ::pwrite(descriptor_, from, n, static_cast<off_t>(offset + before));
            });
}

void File::charge_up_to(std::uint64_t end) {
  if (meter_ == nullptr || end <= charged_) return;
  meter_->charge(end - charged_, path_);
  charged_ = end;
}

void File::sync() {
  int error = detail::injected_error(IoOperation::kSync);
  while (error == 0 && ::fsync(descriptor_) != 0) {
    if (errno == EINVAL || errno == EROFS) return;  // a pipe or device that has nothing to force
    if (errno != EINTR) error = errno;
  }
  if (error != 0) throw_system_error("force to disk", path_, error);
}

void File::close() {
  if (descriptor_ < 0) return;
  const int descriptor = std::exchange(descriptor_, -1);
  if (descriptor == STDOUT_FILENO) return;
  int error = detail::injected_error(IoOperation::kClose);
  // On Linux the descriptor is gone even when close was interrupted: never twice.
  if (::close(descriptor) != 0 && errno != EINTR && error == 0) error = errno;
  if (error != 0) throw_system_error("complete", path_, error);
}

std::uint64_t File::size() const {
  struct stat status {};
  if (::fstat(descriptor_, &status) != 0) throw_system_error("look at", path_, errno);
  return static_cast<std::uint64_t>(status.st_size);
}

IoTotals io_totals() {
  return {total_read.load(std::memory_order_relaxed),
          total_written.load(std::memory_order_relaxed)};
}

}  // namespace stream_recon
