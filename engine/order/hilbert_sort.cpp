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
#include "io/error.h"
#include "spatial/hilbert.h"

namespace stream_recon {
namespace {

constexpr std::size_t kBatch = 1 << 13;
constexpr std::size_t kKeysPerTask = 1 << 14;

/// Memory beside the run or the merge: the spool's reader, a batch and one writer.
constexpr std::uint64_t kFixedMemory =
    kBatch * sizeof(StoredPoint) + 2 * record_file_memory(std::uint64_t{1} << 19);

/// Writes sorted points to the store, each distinct one once.
class StoreWriter {
 public:
  explicit StoreWriter(ScratchDirectory& scratch)
      : writer_(create_records<StoredPoint>(scratch, kPointStore, kPointStoreBlock)) {}

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
      : cloud_(cloud), context_(context), curve_(cloud.box) {}

  OrderResult sort() {
    const Reservation fixed = context_.budget.reserve(kFixedMemory, "ordering the points");
    context_.progress.begin_stage("order", cloud_.finite_points(), "points");
    StoreWriter store(context_.scratch);
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
    ScratchReader<StoredPoint> spool(context_.scratch, kIngestSpool);
    for (std::uint64_t done = 0; done < count; done += run.size()) {
      fill(spool, run, std::min(length, count - done));
      sort_run(run);
      if (length == count) {
        for (const SortRecord& record : run) store.append(record.stored);
      } else {
        write_run(run);
      }
      context_.progress.advance(run.size());
    }
  }

  void fill(ScratchReader<StoredPoint>& spool, std::vector<SortRecord>& run, std::uint64_t length) {
    run.clear();
    std::vector<StoredPoint> batch(kBatch);
    while (run.size() < length) {
      context_.stop.check();
      const std::size_t want = std::min<std::uint64_t>(batch.size(), length - run.size());
      const std::size_t got = spool.read({batch.data(), want});
      if (got == 0) throw IoError("the ingest spool ended early; run again");
      for (std::size_t i = 0; i < got; ++i) run.push_back({0, batch[i]});
    }
  }

  void sort_run(std::vector<SortRecord>& run) const {
    parallel_for_ranges(run.size(), kKeysPerTask, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) run[i].key = curve_.key(run[i].stored.point);
    });
    context_.stop.check();
    parallel_sort(run.begin(), run.end(), std::less<>());
    context_.stop.check();
  }

  void write_run(std::span<const SortRecord> run) {
    auto writer = create_records<SortRecord>(context_.scratch, next_name(), kRunBlock);
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
        std::max<std::uint64_t>(2, context_.budget.available() / RunMerger::memory(1));
    while (runs_.size() > fan_in) merge_first_runs(fan_in);
    const Reservation memory =
        context_.budget.reserve(RunMerger::memory(runs_.size()), "merging sorted runs");
    context_.progress.begin_stage("order: merge", cloud_.finite_points(), "points");
    merge(runs_, [&store](const SortRecord& record) { store.append(record.stored); });
  }

  void merge_first_runs(std::uint64_t fan_in) {
    const Reservation memory =
        context_.budget.reserve(RunMerger::memory(fan_in), "merging sorted runs");
    const auto cut = runs_.begin() + static_cast<std::ptrdiff_t>(fan_in);
    const std::vector<std::string> group(runs_.begin(), cut);
    runs_.erase(runs_.begin(), cut);
    auto writer = create_records<SortRecord>(context_.scratch, next_name(), kRunBlock);
    merge(group, [&writer](const SortRecord& record) { writer.append(record); });
    writer.finish();
  }

  /// Hands the records of `runs` over in order and removes the runs.
  template <class Take>
  void merge(const std::vector<std::string>& runs, const Take& take) {
    RunMerger merger(context_.scratch, runs);
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
  std::vector<std::string> runs_;
  std::uint64_t names_ = 0;
};

}  // namespace

OrderResult hilbert_sort(const CloudSummary& cloud, const StageContext& context) {
  return HilbertSort(cloud, context).sort();
}

}  // namespace stream_recon
