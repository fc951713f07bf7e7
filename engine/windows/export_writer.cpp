#include "engine/windows/export_writer.h"

#include <span>

namespace stream_recon {
namespace {

std::string unfinished(const std::string& name) {
  return name + ".begun";
}

template <class Record>
ExportRecord as_record(const Record& record) {
  ExportRecord bytes;
  std::memcpy(bytes.data(), &record, sizeof record);
  return bytes;
}

}  // namespace

ExportWriter::~ExportWriter() {
  if (!writer_) return;
  writer_.reset();
  scratch_.remove(unfinished(name_));
}

ExportWriter::Pending& ExportWriter::find_pending(ExportKind kind, std::uint64_t chunk) {
  const auto [at, is_new] = pending_.try_emplace({kind, chunk});
  if (is_new) at->second = {kind, chunk, {}};
  return at->second;
}

void ExportWriter::flush(Pending& pending) {
  if (pending.records.empty()) return;
  if (!writer_) {
    writer_.emplace(create_records<ExportRecord>(scratch_, unfinished(name_), kExportBlock));
  }
  const std::size_t count = pending.records.size();
  writer_->append(pending.records);
  parts_.push_back({.chunk = pending.chunk,
                    .first = records_,
                    .count = static_cast<std::uint32_t>(count),
                    .kind = pending.kind});
  records_ += count;
  pending_count_ -= count;
  pending.records.clear();
}

void ExportWriter::flush_all() {
  for (auto& entry : pending_) flush(entry.second);
  pending_.clear();
  last_ = {};
}

std::uint64_t ExportWriter::finish() {
  flush_all();
  if (!writer_) return 0;
  for (const ExportPart& part : parts_) writer_->append(as_record(part));
  writer_->append(as_record(ExportTail{.parts = parts_.size(), .records = records_}));
  writer_->finish();
  writer_.reset();
  scratch_.rename(unfinished(name_), name_);
  return records_;
}

}  // namespace stream_recon
