// The pages of a TIFF file as slices.
//
// Guarantees: values are those that are stored, but where 0 is white they are turned round, so that
// larger is brighter; colour is refused, and so are missing pixels: where their place lies beyond
// the file's end on opening a page, where they cannot be unpacked on reading it.
// Memory: one strip or tile, and 8 bytes a page. Thread rule: one user.
#pragma once

#include <tiffio.h>

#include <bit>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "tools/slices/slice_image.h"

namespace stream_recon {

class TiffPages {
 public:
  /// \throw InputError
  explicit TiffPages(const std::string& path);
  ~TiffPages();
  TiffPages(const TiffPages&) = delete;
  TiffPages& operator=(const TiffPages&) = delete;

  std::size_t size() const { return directories_.size(); }

  /// Goes to a page. \throw InputError
  ImageShape open(std::size_t page);

  /// Fills `out` with the pixels of the page that is open. \throw InputError
  void read(std::span<double> out);

  /// What ImageJ writes instead of directories beyond 4 GB: pages that follow the first without a
  /// description, in the file's own order of bytes. 0 if there are none.
  std::size_t undescribed_pages() const;

  /// Of the page that is open: the byte from which on its pixels lie one after the other.
  /// \throw InputError they are packed
  std::uint64_t start_of_plain_pixels() const;
  std::endian byte_order() const;

 private:
  void read_strips(std::span<double> out);
  void read_tiles(std::span<double> out);
  void widen_row(const std::byte* row, std::span<double> out) const;
  void check_places();
  [[noreturn]] void fail() const;
  static int keep_reason(TIFF*, void* self, const char*, const char* format, va_list values);
  static int ignore(TIFF*, void*, const char*, const char*, va_list) { return 1; }

  std::string path_;
  std::string reason_;
  std::vector<std::uint64_t> directories_;
  TIFF* tiff_ = nullptr;
  ImageShape shape_;
  bool zero_is_white_ = false;
};

}  // namespace stream_recon
