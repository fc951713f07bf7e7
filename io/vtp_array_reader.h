// The wanted data arrays of a VTK XML file (PolyData, UnstructuredGrid), one after the other.
//
// Guarantees: arrays inside the XML come in the order of the file; then the appended ones, in the
// order of their offsets, so nothing is seeked and a pipe will do. What follows the last wanted
// array in an appended section is not read.
// Memory: that of VtpStream, and about 150 bytes for each wanted array that is appended.
// Thread rule: one reader.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "io/byte_source.h"
#include "io/vtp_document.h"
#include "io/vtp_stream.h"

namespace stream_recon {

class VtpArrayReader {
 public:
  using Filter = std::function<bool(const VtpArray&)>;

  /// `source` must outlive the reader. \throw InputError no VTK XML file of a known kind; IoError
  VtpArrayReader(ByteSource& source, Filter wanted);
  ~VtpArrayReader();
  VtpArrayReader(const VtpArrayReader&) = delete;
  VtpArrayReader& operator=(const VtpArrayReader&) = delete;

  /// Steps over what is left of the current array to the next wanted one; nothing at the end.
  /// \throw InputError, IoError
  std::optional<VtpArray> next();

  /// Fills `out`, which holds a multiple of the values' size, with values of the current array in
  /// order(); fewer only at its end. \throw InputError, IoError
  std::size_t read(std::span<char> out);

  /// Byte order of what read() gives.
  std::endian order() const;
  bool is_poly_data() const { return document_.is_poly_data(); }
  /// The wanted appended arrays, complete as soon as next() gave one of them.
  std::span<const VtpArray> appended() const { return appended_; }

 private:
  class AppendedText;

  std::optional<VtpArray> next_appended();
  void start_appended();
  void open_stream();

  ByteSource& source_;
  VtpDocument document_;
  Filter wanted_;
  std::vector<VtpArray> appended_;
  std::size_t appended_given_ = 0;
  std::optional<std::uint64_t> appended_begin_;  ///< place of the appended section's first byte
  std::optional<VtpArray> current_;
  std::unique_ptr<VtpText> appended_text_;
  std::unique_ptr<VtpStream> stream_;  ///< opened by the first read() of an array
};

}  // namespace stream_recon
