// A file, every error of which is named.
//
// Guarantees: a call does all of its work or throws an IoError that names the file, the operation,
// the byte and what to do; short and interrupted system calls are continued.
// Thread rule: read_at() may run side by side with itself; everything else belongs to one thread.
// Memory: no buffer, so hand over large pieces. Cost: one system call a piece.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "io/storage_meter.h"

namespace stream_recon {

class File {
 public:
  /// Opens an existing file (or pipe, or device) for reading. \throw IoError
  static File open(const std::string& path);
  /// Makes a new file for writing and reading; its growth is charged to `meter`, if any.
  /// \throw IoError cannot create, or something of that name exists
  static File create(const std::string& path, std::shared_ptr<StorageMeter> meter = nullptr);
  /// Standard output; stays open when this object goes.
  static File standard_output();

  File() = default;
  File(File&& other) noexcept;
  File& operator=(File&& other) noexcept;
  /// Closes without a word; close() is the way to learn that the last bytes were lost.
  ~File();

  /// Reads on until `out` is full or the file ends; the number of bytes read. \throw IoError
  std::size_t read(std::span<std::byte> out);
  /// Fills `out` from byte `offset` on. \throw IoError, also when the file ends before
  void read_at(std::uint64_t offset, std::span<std::byte> out) const;
  /// Writes behind what was written last. \throw IoError
  void write(std::span<const std::byte> data);
  /// Writes at byte `offset`; the sequential position stays. \throw IoError
  void write_at(std::uint64_t offset, std::span<const std::byte> data);
  /// Forces the bytes to the device. \throw IoError
  void sync();
  /// \throw IoError bytes written before were lost
  void close();

  bool is_open() const { return descriptor_ >= 0; }
  /// Bytes on disk now. \throw IoError
  std::uint64_t size() const;
  /// Where sequential reading or writing stands, in bytes.
  std::uint64_t position() const { return position_; }
  const std::string& path() const { return path_; }

 private:
  File(int descriptor, std::string path, std::shared_ptr<StorageMeter> meter);
  void charge_up_to(std::uint64_t end);

  int descriptor_ = -1;
  std::string path_;
  std::shared_ptr<StorageMeter> meter_;
  std::uint64_t position_ = 0;
  std::uint64_t charged_ = 0;
};

/// Bytes moved by all files of the process since its start; a stage reports the difference.
struct IoTotals {
  std::uint64_t bytes_read = 0;
  std::uint64_t bytes_written = 0;
};
IoTotals io_totals();

}  // namespace stream_recon
