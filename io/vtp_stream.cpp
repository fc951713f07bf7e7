#include "io/vtp_stream.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "io/vtp_codec.h"

namespace stream_recon {
namespace {

class RawStream : public VtpStream {
 public:
  explicit RawStream(ByteSource& source) : source_(source) {}
  std::size_t read(std::span<char> out) override { return source_.read(out); }

 private:
  ByteSource& source_;
};

/// What both kinds of arrays share: the numbers before the content, and the complaints.
class ArrayStream : public VtpStream {
 protected:
  ArrayStream(std::unique_ptr<VtpStream> stored, VtpArrayLayout layout, const ByteSource& source)
      : stored_(std::move(stored)), layout_(layout), source_(source) {}

  std::uint64_t take_header_number() {
    char bytes[8];
    const std::size_t size = scalar_size(layout_.encoding.header);
    take({bytes, size});
    return size == 4 ? load_scalar<std::uint32_t>(bytes, layout_.encoding.order)
                     : load_scalar<std::uint64_t>(bytes, layout_.encoding.order);
  }

  void take(std::span<char> out) {
    if (stored_->read(out) != out.size()) {
      source_.fail("the file ends inside an array; it is cut short, fetch it again");
    }
  }

  void check_size(std::uint64_t size) const {
    if (layout_.expected && size != *layout_.expected) {
      source_.fail("an array of " + std::to_string(size) + " bytes where " +
                   std::to_string(*layout_.expected) + " are announced; the file is damaged");
    }
  }

  const VtpArrayLayout& layout() const { return layout_; }
  const ByteSource& source() const { return source_; }

 private:
  std::unique_ptr<VtpStream> stored_;
  VtpArrayLayout layout_;
  const ByteSource& source_;
};

class PlainArray : public ArrayStream {
 public:
  PlainArray(std::unique_ptr<VtpStream> stored, const VtpArrayLayout& layout,
             const ByteSource& source)
      : ArrayStream(std::move(stored), layout, source), left_(take_header_number()) {
    check_size(left_);
  }

  std::size_t read(std::span<char> out) override {
    out = out.first(static_cast<std::size_t>(std::min<std::uint64_t>(out.size(), left_)));
    take(out);
    left_ -= out.size();
    return out.size();
  }

 private:
  std::uint64_t left_;
};

class CompressedArray : public ArrayStream {
 public:
  CompressedArray(std::unique_ptr<VtpStream> stored, const VtpArrayLayout& layout,
                  const ByteSource& source)
      : ArrayStream(std::move(stored), layout, source) {
    const std::uint64_t blocks = take_header_number();
    block_size_ = take_header_number();
    last_size_ = take_header_number();
    if (last_size_ == 0) last_size_ = block_size_;
    if (blocks == 0) {
      check_size(0);
      return;
    }
    if (block_size_ == 0 || block_size_ > kLongestVtpBlock || last_size_ > block_size_ ||
        blocks - 1 > (UINT64_MAX - last_size_) / block_size_) {
      source.fail("compressed blocks of " + std::to_string(block_size_) +
                  " bytes; the file is damaged, or write it with a smaller block size");
    }
    check_size((blocks - 1) * block_size_ + last_size_);
    // The table grows as its bytes arrive, so a promise alone takes no memory.
    for (std::uint64_t i = 0; i < blocks; ++i) stored_sizes_.push_back(take_stored_size());
    const bool single = blocks == 1;
    block_.reset(new char[single ? last_size_ : block_size_]);
  }

  std::size_t read(std::span<char> out) override {
    std::size_t done = 0;
    while (done < out.size()) {
      if (begin_ == end_) {
        if (next_block_ == stored_sizes_.size()) break;
        decompress_block();
      }
      const std::size_t count = std::min(out.size() - done, end_ - begin_);
      std::memcpy(out.data() + done, block_.get() + begin_, count);
      begin_ += count;
      done += count;
    }
    return done;
  }

 private:
  std::uint32_t take_stored_size() {
    const std::uint64_t size = take_header_number();
    // Neither compressor makes a block longer than this.
    if (size > block_size_ + block_size_ / 128 + 1024) {
      source().fail("a compressed block longer than its content; the file is damaged");
    }
    return static_cast<std::uint32_t>(size);
  }

  void decompress_block() {
    compressed_.resize(stored_sizes_[next_block_]);
    take(compressed_);
    ++next_block_;
    begin_ = 0;
    end_ = next_block_ == stored_sizes_.size() ? last_size_ : block_size_;
    const std::span<char> out(block_.get(), end_);
    const bool good = layout().encoding.compressor == VtpCompressor::kZlib
                          ? decompress_zlib_block(compressed_, out)
                          : decompress_lz4_block(compressed_, out);
    if (!good) source().fail("a block that does not decompress; the file is damaged");
  }

  std::uint64_t block_size_ = 0;
  std::uint64_t last_size_ = 0;
  std::vector<std::uint32_t> stored_sizes_;
  std::size_t next_block_ = 0;
  std::vector<char> compressed_;
  std::unique_ptr<char[]> block_;
  std::size_t begin_ = 0;  ///< unread bytes of block_
  std::size_t end_ = 0;
};

}  // namespace

std::unique_ptr<VtpStream> make_raw_stream(ByteSource& source) {
  return std::make_unique<RawStream>(source);
}

std::unique_ptr<VtpStream> make_array_stream(std::unique_ptr<VtpStream> stored,
                                             const VtpArrayLayout& layout,
                                             const ByteSource& source) {
  if (layout.encoding.compressor == VtpCompressor::kNone) {
    return std::make_unique<PlainArray>(std::move(stored), layout, source);
  }
  return std::make_unique<CompressedArray>(std::move(stored), layout, source);
}

}  // namespace stream_recon
