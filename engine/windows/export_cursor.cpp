#include "engine/windows/export_cursor.h"

namespace stream_recon::detail {

std::size_t RawExportCursor::read(std::span<ExportRecord> out) {
  std::size_t filled = 0;
  while (filled < out.size() && !parts_.empty()) {
    const ExportReader::Part& part = parts_.front();
    const std::size_t count = std::min<std::size_t>(out.size() - filled, part.count - done_);
    if (!file_ || open_ != part.file) {
      file_ = std::make_unique<ScratchReader<ExportRecord>>(reader_->scratch_,
                                                            reader_->files_[part.file]);
      open_ = part.file;
    }
    if (file_->read_at(part.first + done_, out.subspan(filled, count)) != count) {
      throw_damaged_export(reader_->files_[part.file]);
    }
    filled += count;
    done_ += static_cast<std::uint32_t>(count);
    if (done_ == part.count) {
      parts_ = parts_.subspan(1);
      done_ = 0;
    }
  }
  return filled;
}

}  // namespace stream_recon::detail
