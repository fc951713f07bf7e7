#include "engine/windows/export_reader.h"

#include <algorithm>
#include <charconv>
#include <system_error>
#include <tuple>

#include "io/error.h"

namespace stream_recon {
namespace {

constexpr std::uint64_t kTableBatch = 1024;

template <class Struct>
Struct from_record(const ExportRecord& record) {
  Struct result;
  std::memcpy(&result, record.data(), sizeof result);
  return result;
}

}  // namespace

void throw_damaged_export(const std::string& name) {
  throw IoError("the scratch file " + name +
                " does not hold what a window handed on; start again without --resume");
}

std::optional<std::uint64_t> export_first_rank(std::string_view name) {
  if (!name.starts_with(kExportPrefix)) return std::nullopt;
  name.remove_prefix(kExportPrefix.size());
  std::uint64_t rank = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), rank);
  if (error != std::errc() || end != name.data() + name.size()) return std::nullopt;
  return rank;
}

ExportReader::ExportReader(const ScratchDirectory& scratch, MemoryBudget& budget)
    : scratch_(scratch),
      budget_(budget),
      memory_(budget.reserve(0, "the table of what windows handed on")) {
  for (const std::string& name : scratch.names()) {
    if (export_first_rank(name)) read_table(scratch, name);
  }
  for (auto& parts : parts_) {
    std::sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) {
      return std::tie(a.chunk, a.file, a.first) < std::tie(b.chunk, b.file, b.first);
    });
  }
}

void ExportReader::read_table(const ScratchDirectory& scratch, const std::string& name) {
  const auto file = static_cast<std::uint32_t>(files_.size());
  files_.push_back(name);
  ScratchReader<ExportRecord> reader(scratch, name);
  const std::uint64_t count = reader.count();
  ExportRecord record;
  if (count == 0 || reader.read_at(count - 1, {&record, 1}) != 1) throw_damaged_export(name);
  const auto tail = from_record<ExportTail>(record);
  if (tail.mark != ExportTail::kMark || tail.parts + tail.records + 1 != count)
    throw_damaged_export(name);
  records_ += tail.records;
  // Twice, because a vector that grows holds its elements twice for a moment.
  memory_.resize(memory_.bytes() + 2 * tail.parts * sizeof(Part));

  std::vector<ExportRecord> batch(std::min(kTableBatch, tail.parts));
  for (std::uint64_t done = 0; done < tail.parts; done += batch.size()) {
    batch.resize(std::min<std::uint64_t>(batch.size(), tail.parts - done));
    reader.read_at(tail.records + done, batch);
    for (const ExportRecord& bytes : batch) {
      const auto part = from_record<ExportPart>(bytes);
      const auto kind = static_cast<std::size_t>(part.kind);
      if (kind >= kExportKinds || part.first + part.count > tail.records)
        throw_damaged_export(name);
      parts_[kind].push_back({part.chunk, part.first, file, part.count});
    }
  }
}

std::span<const ExportReader::Part> ExportReader::parts_of(ExportKind kind,
                                                           std::uint64_t chunk) const {
  const auto& parts = parts_[static_cast<std::size_t>(kind)];
  const auto begin = std::partition_point(parts.begin(), parts.end(),
                                          [chunk](const Part& p) { return p.chunk < chunk; });
  const auto end =
      std::partition_point(begin, parts.end(), [chunk](const Part& p) { return p.chunk == chunk; });
  return {begin, end};
}

std::uint64_t ExportReader::count(ExportKind kind, std::uint64_t chunk) const {
  std::uint64_t count = 0;
  for (const Part& part : parts_of(kind, chunk)) count += part.count;
  return count;
}

std::vector<std::uint64_t> ExportReader::chunks(ExportKind kind) const {
  std::vector<std::uint64_t> chunks;
  for (const Part& part : parts_[static_cast<std::size_t>(kind)]) {
    if (chunks.empty() || chunks.back() != part.chunk) chunks.push_back(part.chunk);
  }
  return chunks;
}

void ExportReader::visit_raw(ExportKind kind, std::uint64_t chunk, const VisitRaw& visit) const {
  const auto parts = parts_of(kind, chunk);
  if (parts.empty()) return;
  const Reservation memory = budget_.reserve(read_memory(), "reading what windows handed on");
  std::vector<ExportRecord> records;
  for (auto part = parts.begin(); part != parts.end();) {
    const std::uint32_t file = part->file;
    ScratchReader<ExportRecord> reader(scratch_, files_[file]);
    for (; part != parts.end() && part->file == file; ++part) {
      records.resize(part->count);
      if (reader.read_at(part->first, records) != records.size())
        throw_damaged_export(files_[file]);
      visit(records);
    }
  }
}

}  // namespace stream_recon
