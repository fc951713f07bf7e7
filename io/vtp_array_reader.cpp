#include "io/vtp_array_reader.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

namespace stream_recon {

/// The characters of an appended base64 section, up to the tag that ends it.
class VtpArrayReader::AppendedText : public VtpText {
 public:
  explicit AppendedText(ByteSource& source) : source_(source) {}

  std::string_view peek() override {
    const std::string_view ready = source_.peek(1);
    return ready.substr(0, ready.find('<'));
  }
  void consume(std::size_t count) override { source_.consume(count); }

 private:
  ByteSource& source_;
};

VtpArrayReader::VtpArrayReader(ByteSource& source, Filter wanted)
    : source_(source), document_(source), wanted_(std::move(wanted)) {}

VtpArrayReader::~VtpArrayReader() = default;

std::optional<VtpArray> VtpArrayReader::next() {
  constexpr std::size_t kMostArrays = 1 << 16;
  stream_.reset();
  current_.reset();
  if (appended_begin_) return next_appended();
  while (std::optional<VtpArray> array = document_.next()) {
    if (!wanted_(*array)) continue;
    if (array->storage != VtpStorage::kAppended) return current_ = std::move(array);
    if (appended_.size() == kMostArrays) {
      source_.fail("more than " + std::to_string(kMostArrays) + " pieces; split the file");
    }
    appended_.push_back(std::move(*array));
  }
  if (appended_.empty()) return std::nullopt;
  if (!document_.appended()) {
    source_.fail("arrays are appended but there is no AppendedData; the file is damaged");
  }
  start_appended();
  return next_appended();
}

void VtpArrayReader::start_appended() {
  std::string_view ready = source_.peek(1);
  while (!ready.empty() && std::string_view(" \t\r\n").find(ready.front()) != ready.npos) {
    source_.consume(1);
    ready = source_.peek(1);
  }
  if (!ready.starts_with('_')) {
    source_.fail("no '_' before the appended data; the file is cut short or damaged");
  }
  source_.consume(1);
  appended_begin_ = source_.offset();
  appended_text_ = std::make_unique<AppendedText>(source_);
  std::stable_sort(appended_.begin(), appended_.end(),
                   [](const VtpArray& a, const VtpArray& b) { return a.offset < b.offset; });
}

std::optional<VtpArray> VtpArrayReader::next_appended() {
  if (appended_given_ == appended_.size()) return std::nullopt;
  current_ = appended_[appended_given_++];
  return current_;
}

void VtpArrayReader::open_stream() {
  const VtpStorage storage =
      current_->storage == VtpStorage::kAppended ? *document_.appended() : current_->storage;
  if (current_->storage == VtpStorage::kAppended) {
    const std::uint64_t passed = source_.offset() - *appended_begin_;
    if (current_->offset < passed) {
      source_.fail("the array at offset " + std::to_string(current_->offset) +
                   " overlaps the one before; the file is damaged");
    }
    const std::uint64_t gap = current_->offset - passed;
    if (source_.skip(gap) != gap) {
      source_.fail("the file ends before the array at offset " + std::to_string(current_->offset) +
                   "; it is cut short, fetch it again");
    }
  } else if (storage == VtpStorage::kNumbers) {
    stream_ = make_number_stream(document_.text(), current_->type, source_);
    return;
  }
  VtpText& text = current_->storage == VtpStorage::kAppended ? *appended_text_ : document_.text();
  std::optional<std::uint64_t> expected;
  if (current_->values) expected = *current_->values * scalar_size(current_->type);
  stream_ = make_array_stream(storage == VtpStorage::kAppended ? make_raw_stream(source_)
                                                               : make_base64_stream(text, source_),
                              {document_.encoding(), expected}, source_);
}

std::size_t VtpArrayReader::read(std::span<char> out) {
  if (!stream_) open_stream();
  return stream_->read(out);
}

std::endian VtpArrayReader::order() const {
  return current_->storage == VtpStorage::kNumbers ? std::endian::native
                                                   : document_.encoding().order;
}

}  // namespace stream_recon
