// The bytes of a file from a given one on, in their order, unpacked on the way.
//
// Guarantees: bytes that are not there are never made up: read() says how many there were, and
// damaged packed data is an error. Thread rule: one reader. Memory: 64 KiB and zlib's 40 KiB.
// Source: RFC 1950 and 1952; a gzip file may have several members.
#pragma once

#include <zlib.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "io/file.h"

namespace stream_recon {

enum class Packing { kNone, kZlib };  ///< kZlib: zlib or gzip, as the first bytes say

/// kZlib for a gzip file. \throw InputError no such file
Packing packing_of(const std::string& path);

/// \throw InputError no file of that name
std::uint64_t length_of_file(const std::string& path);

class UnpackedFile {
 public:
  /// Begins at byte `start` of the file. \throw InputError no such file \throw IoError
  UnpackedFile(const std::string& path, Packing packing, std::uint64_t start);
  ~UnpackedFile();
  UnpackedFile(const UnpackedFile&) = delete;
  UnpackedFile& operator=(const UnpackedFile&) = delete;

  /// Fills `out` with the next unpacked bytes; fewer only at the end of the file.
  /// \throw InputError damaged \throw IoError
  std::size_t read(std::span<std::byte> out);

  /// Steps over `count` unpacked bytes; the number stepped over is less only at the end.
  std::uint64_t skip(std::uint64_t count);

  /// Reads what is left, to see that the packed data has its end and checksum.
  /// \throw InputError damaged or truncated
  void finish();

  /// Unpacked bytes read or stepped over.
  std::uint64_t position() const { return position_; }

 private:
  std::size_t unpack(std::span<std::byte> out);
  bool refill();
  bool begins_next_member();

  std::string path_;
  Packing packing_;
  File file_;
  std::uint64_t start_;
  std::uint64_t position_ = 0;
  std::vector<std::byte> packed_;
  z_stream zlib_{};
  bool has_ended_ = false;  // the packed data, as its own end says
};

}  // namespace stream_recon
