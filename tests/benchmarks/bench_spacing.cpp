// Times the local spacing of a cloud's points:
//   make-cloud folded -n 2000000 -o - | bench-spacing - THREADS MEMORY_MB
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <vector>

#include "engine/order/hilbert_sort.h"
#include "engine/parallel.h"
#include "engine/process_memory.h"
#include "engine/scratch_records.h"
#include "engine/spacing/spacing_stage.h"

namespace stream_recon {
namespace {

void run(const char* input, unsigned threads, std::uint64_t memory_bytes) {
  const ThreadLimit limit(threads);
  ScratchDirectory scratch({.parent = "/var/tmp"});
  MemoryBudget budget(memory_bytes);
  Progress progress{ProgressStyle::kNone};
  StopRequest stop;
  const StageContext context{scratch, budget, progress, stop};
  const CloudSummary cloud = ingest({{input}, InputFormat::kAuto}, context);
  const OrderResult order = hilbert_sort(cloud, context);
  const CloudIndex index = build_index(cloud, order.point_count, context);
  const auto began = std::chrono::steady_clock::now();
  const std::clock_t began_work = std::clock();
  measure_spacing(index, cloud.spacing, context);
  const std::clock_t work = std::clock() - began_work;
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - began;
  std::vector<float> spacings(order.point_count);
  ScratchReader<float>(scratch, kSpacings).read(spacings);
  std::sort(spacings.begin(), spacings.end());
  const auto quantile = [&](double q) {
    return spacings[static_cast<std::size_t>(q * static_cast<double>(spacings.size() - 1))];
  };
  const auto points = static_cast<double>(order.point_count);
  fmt::print(
      "{} points, {:.2f} s, {:.3f} us of work a point; spacing {:.4g} {:.4g} {:.4g} "
      "{:.4g} {:.4g} (0, 10, 50, 90, 100 %); peak of the process {} MB\n",
      order.point_count, seconds.count(), static_cast<double>(work) * 1e6 / CLOCKS_PER_SEC / points,
      quantile(0), quantile(0.1), quantile(0.5), quantile(0.9), quantile(1),
      peak_resident_bytes() >> 20);
}

}  // namespace
}  // namespace stream_recon

int main(int argc, char** argv) {
  if (argc != 4) {
    fmt::print(stderr, "usage: bench-spacing INPUT THREADS MEMORY_MB\n");
    return 64;
  }
  stream_recon::run(argv[1], static_cast<unsigned>(std::atoi(argv[2])),
                    std::strtoull(argv[3], nullptr, 10) << 20);
}
