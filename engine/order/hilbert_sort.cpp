#include "engine/order/hilbert_sort.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "engine/order/point_store.h"
#include "engine/order/run_merger.h"
#include "engine/order/sort_record.h"
#include "engine/parallel.h"
#include "engine/parallel_records.h"
#include "io/error.h"
#include "spatial/hilbert.h"

namespace stream_recon {
namespace {

constexpr std::size_t kBatch = 1 << 13;

/// Memory beside the run or the merge: how much is read and written at a time.
struct Lanes {
  std::size_t readers;
  std::size_t run_blocks;
  std::size_t store_blocks;

  explicit Lanes(const MemoryBudget& budget)
      : readers(blocks_at_once(kIngestBlock, budget)),
        run_blocks(blocks_at_once(kRunBlock, budget)),
        store_blocks(blocks_at_once(kPointStoreBlock, budget)) {}

  std::uint64_t memory() const {
    return readers * (record_cursor_memory(kIngestBlock) + kBatch * sizeof(StoredPoint)) +
           run_blocks * record_file_memory(kRunBlock) +
           store_blocks * record_file_memory(kPointStoreBlock);
  }
};

/// Writes sorted points to the store, each distinct one once.
class StoreWriter {
 public:
  StoreWriter(ScratchDirectory& scratch, std::size_t blocks)
      : writer_(create_records<StoredPoint>(scratch, kPointStore, kPointStoreBlock, blocks)) {}

  void append(const StoredPoint& next) {
    if (any_ && next.point == last_) {
      ++result_.duplicates;
      return;
    }
    any_ = true;
    last_ = next.point;
    writer_.append(next);
    ++result_.point_count;
  }

  OrderResult finish() {
    writer_.finish();
    return result_;
  }

 private:
  RecordWriter<StoredPoint> writer_;
  OrderResult result_;
  Point3 last_;
  bool any_ = false;
};

class HilbertSort {
 public:
  HilbertSort(const CloudSummary& cloud, const StageContext& context)
      : cloud_(cloud), context_(context), curve_(cloud.box), lanes_(context.budget) {}

  OrderResult sort() {
    const Reservation fixed = context_.budget.reserve(lanes_.memory(), "ordering the points");
    context_.progress.begin_stage("order", cloud_.finite_points(), "points");
    StoreWriter store(context_.scratch, lanes_.store_blocks);
    make_runs(store);
    merge_runs(store);
    context_.progress.end_stage();
    return store.finish();
  }

 private:
  /// Cuts the spool into sorted runs; a single one goes to the store at once.
  void make_runs(StoreWriter& store) {
    const std::uint64_t count = cloud_.finite_points();
    const std::uint64_t most = context_.budget.available() / sizeof(SortRecord);
    const std::uint64_t length = std::max<std::uint64_t>(1, std::min(count, most));
    const Reservation memory =
        context_.budget.reserve(length * sizeof(SortRecord), "a run of the Hilbert sort");
    std::vector<SortRecord> run;
    run.reserve(length);
    const RecordFile<StoredPoint> spool(context_.scratch.open(kIngestSpool));
    for (std::uint64_t done = 0; done < count; done += run.size()) {
      run.resize(std::min(length, count - done));
      fill(spool, done, run);
      context_.stop.check();
      parallel_sort(run.begin(), run.end(), std::less<>());
      context_.stop.check();
      if (length == count) {
        for (const SortRecord& record : run) store.append(record.stored);
      } else {
        write_run(run);
      }
      context_.progress.advance(run.size());
    }
  }

  /// The records from `first` on, with their keys; each reader takes a part of the run.
  void fill(const RecordFile<StoredPoint>& spool, std::uint64_t first,
            std::span<SortRecord> run) const {
    const std::size_t share = run.size() / lanes_.readers + 1;
    parallel_for_ranges(lanes_.readers, 1, [&](std::size_t begin, std::size_t end) {
      const std::size_t from = std::min(begin * share, run.size());
      const std::size_t to = std::min(end * share, run.size());
      fill_part(spool, first + from, run.subspan(from, to - from));
    });
  }

  void fill_part(const RecordFile<StoredPoint>& spool, std::uint64_t first,
                 std::span<SortRecord> part) const {
    RecordCursor<StoredPoint> cursor(spool);
    cursor.seek(first);
    std::vector<StoredPoint> batch(kBatch);
    while (!part.empty()) {
      context_.stop.check();
      const std::size_t got = cursor.read(std::span(batch).first(std::min(kBatch, part.size())));
      if (got == 0) throw IoError("the ingest spool ended early; run again");
      for (std::size_t i = 0; i < got; ++i) part[i] = {curve_.key(batch[i].point), batch[i]};
      part = part.subspan(got);
    }
  }

  void write_run(std::span<const SortRecord> run) {
    auto writer =
        create_records<SortRecord>(context_.scratch, next_name(), kRunBlock, lanes_.run_blocks);
    writer.append(run);
    writer.finish();
  }

  std::string next_name() {
    runs_.push_back(fmt::format("run_{}", names_++));
    return runs_.back();
  }

  /// Merges until one pass leads to the store.
  void merge_runs(StoreWriter& store) {
    if (runs_.empty()) return;
    const std::uint64_t fan_in =
        std::max<std::uint64_t>(2, context_.budget.available() / RunMerger<SortRecord>::memory(1));
    while (runs_.size() > fan_in) merge_first_runs(fan_in);
    const Reservation memory =
        context_.budget.reserve(RunMerger<SortRecord>::memory(runs_.size()), "merging sorted runs");
    context_.progress.begin_stage("order: merge", cloud_.finite_points(), "points");
    merge(runs_, [&store](const SortRecord& record) { store.append(record.stored); });
  }

  void merge_first_runs(std::uint64_t fan_in) {
    const Reservation memory =
        context_.budget.reserve(RunMerger<SortRecord>::memory(fan_in), "merging sorted runs");
    const auto cut = runs_.begin() + static_cast<std::ptrdiff_t>(fan_in);
    const std::vector<std::string> group(runs_.begin(), cut);
    runs_.erase(runs_.begin(), cut);
    auto writer =
        create_records<SortRecord>(context_.scratch, next_name(), kRunBlock, lanes_.run_blocks);
    merge(group, [&writer](const SortRecord& record) { writer.append(record); });
    writer.finish();
  }

  /// Hands the records of `runs` over in order and removes the runs.
  template <class Take>
  void merge(const std::vector<std::string>& runs, const Take& take) {
    RunMerger<SortRecord> merger(context_.scratch, runs);
    SortRecord record;
    for (std::uint64_t count = 0; merger.next(record); ++count) {
      if (count % kBatch == 0) {
        context_.stop.check();
        context_.progress.advance(count == 0 ? 0 : kBatch);
      }
      take(record);
    }
    for (const std::string& run : runs) context_.scratch.remove(run);
  }

  const CloudSummary& cloud_;
  const StageContext& context_;
  HilbertCurve curve_;
  const Lanes lanes_;
  std::vector<std::string> runs_;
  std::uint64_t names_ = 0;
};

}  // namespace

OrderResult hilbert_sort(const CloudSummary& cloud, const StageContext& context) {
  return HilbertSort(cloud, context).sort();
}

}  // namespace stream_recon
