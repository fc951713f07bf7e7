#include "engine/restart/artefact_check.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>

#include "engine/order/point_store.h"
#include "engine/restart/run_journal.h"
#include "engine/windows/export_reader.h"
#include "io/error.h"

namespace stream_recon {
namespace {

/// Reads every block. \throw IoError damaged
std::uint64_t count_intact_records(const ScratchDirectory& scratch, const std::string& name,
                                   std::size_t record_bytes) {
  const BlockFile file(scratch.open(name), record_bytes);
  BlockCursor cursor(file);
  for (std::uint64_t block = 0; block < file.block_count(); ++block) (void)cursor.block(block);
  return file.record_count();
}

template <class Check>
bool holds(const Check& check) {
  try {
    return check();
  } catch (const IoError&) {
    return false;
  }
}

bool is_intact(const ScratchDirectory& scratch, const char* name, std::uint64_t points) {
  return holds([&] {
    return scratch.has(name) && count_intact_records(scratch, name, sizeof(StoredPoint)) == points;
  });
}

bool is_export_of(const WindowProgress& windows, const std::string& name) {
  return std::any_of(windows.done.begin(), windows.done.end(), [&](const OwnedRange& range) {
    const auto first = export_first_rank(name);
    return first && *first >= range.first && *first < range.end();
  });
}

bool are_intact(const ScratchDirectory& scratch, const WindowProgress& windows) {
  return holds([&] {
    for (const std::string& name : scratch.names()) {
      if (export_first_rank(name)) count_intact_records(scratch, name, sizeof(ExportRecord));
    }
    MemoryBudget any(std::numeric_limits<std::uint64_t>::max());
    const ExportReader reader(scratch, any);
    return reader.files() == windows.totals.export_files &&
           reader.records() == windows.totals.export_records;
  });
}

bool is_named(const Manifest& manifest, const std::string& name) {
  if (name == kManifest) return true;
  if (name == kPointStore) return manifest.order.has_value();
  if (name == kIngestSpool) return manifest.cloud && !manifest.order;
  return is_export_of(manifest.windows, name);
}

void remove_unnamed(const Manifest& manifest, ScratchDirectory& scratch) {
  for (const std::string& name : scratch.names()) {
    if (!is_named(manifest, name)) scratch.remove(name);
  }
}

}  // namespace

std::string keep_intact_artefacts(Manifest& manifest, ScratchDirectory& scratch) {
  std::string redone;
  const auto points = [&] { return manifest.order->point_count; };
  if (manifest.order && !is_intact(scratch, kPointStore, points())) {
    redone = "the ordered points";
    manifest.order.reset();
    manifest.windows = {};
  }
  const auto finite = [&] { return manifest.cloud->finite_points(); };
  if (manifest.cloud && !manifest.order && !is_intact(scratch, kIngestSpool, finite())) {
    redone = "the points read";
    manifest.cloud.reset();
  }
  remove_unnamed(manifest, scratch);
  if (!are_intact(scratch, manifest.windows)) {
    redone = "what the windows had found";
    manifest.windows = {};
    remove_unnamed(manifest, scratch);
  }
  return redone;
}

}  // namespace stream_recon
