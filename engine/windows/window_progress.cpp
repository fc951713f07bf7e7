#include "engine/windows/window_progress.h"

#include <algorithm>

namespace stream_recon {

void WindowTotals::add(const WindowTotals& part) {
  windows += part.windows;
  splits += part.splits;
  counts.add(part.counts);
  tetrahedra.merge(part.tetrahedra);
  export_files += part.export_files;
  export_records += part.export_records;
}

std::uint64_t WindowProgress::done_points() const {
  std::uint64_t points = 0;
  for (const OwnedRange& range : done) points += range.count;
  return points;
}

void WindowProgress::add_range(const OwnedRange& range) {
  const auto after = std::partition_point(
      done.begin(), done.end(), [&](const OwnedRange& other) { return other.first < range.first; });
  auto at = done.insert(after, range);
  if (at + 1 != done.end() && at->end() == (at + 1)->first) {
    at->count += (at + 1)->count;
    done.erase(at + 1);
  }
  if (at != done.begin() && (at - 1)->end() == at->first) {
    (at - 1)->count += at->count;
    done.erase(at);
  }
}

std::vector<OwnedRange> WindowProgress::open_ranges(std::uint64_t point_count) const {
  std::vector<OwnedRange> open;
  PointRank begin = 0;
  for (const OwnedRange& range : done) {
    if (range.first > begin) open.push_back({begin, range.first - begin});
    begin = range.end();
  }
  if (begin < point_count) open.push_back({begin, point_count - begin});
  return open;
}

}  // namespace stream_recon
