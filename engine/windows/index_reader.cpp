#include "engine/windows/index_reader.h"

#include <algorithm>
#include <span>

namespace stream_recon {
namespace {

constexpr std::uint64_t kOverhead = 128;  // of the cache and the allocator, a page
constexpr std::uint64_t kNodePageBytes = sizeof(NodePage) + kOverhead;
constexpr std::uint64_t kPointPageBytes = sizeof(PointPage) + kOverhead;

// Nodes are asked for more often than points, and are an eighth of their size: they go first.
std::uint64_t node_share(std::uint64_t point_count, std::uint64_t memory) {
  const std::uint64_t all =
      index_layout::quotient_up(point_count, index_layout::kPagePoints) * kNodePageBytes;
  return std::min(all, memory / 2);
}

}  // namespace

std::uint64_t IndexCaches::least_memory(unsigned readers) {
  return (std::uint64_t{readers} + 4) * 4 * (kNodePageBytes + kPointPageBytes);
}

std::uint64_t IndexCaches::most_memory(std::uint64_t point_count) {
  return index_layout::quotient_up(point_count, index_layout::kPagePoints) * kNodePageBytes +
         index_layout::quotient_up(point_count, PointPage::kPoints) * kPointPageBytes +
         (std::uint64_t{1} << 18);
}

IndexCaches::IndexCaches(const ScratchDirectory& scratch, const CloudIndex& index,
                         std::uint64_t memory)
    : scale_(index.scale),
      node_file_(scratch.open(kIndexPages)),
      point_file_(scratch.open(kPointStore)),
      nodes_(std::max<std::uint64_t>(1, node_share(index.point_count, memory) / kNodePageBytes)),
      points_(std::max<std::uint64_t>(
          1, (memory - node_share(index.point_count, memory)) / kPointPageBytes)) {}

PageCache<NodePage>::Pin IndexReader::pin_nodes(std::uint64_t page) {
  return caches_.nodes_.get(page, [&](NodePage& loaded) {
    caches_.node_file_.read_block(page, codec_, stored_,
                                  std::as_writable_bytes(std::span(loaded.nodes)));
  });
}

PageCache<PointPage>::Pin IndexReader::pin_points(std::uint64_t page) {
  return caches_.points_.get(page, [&](PointPage& loaded) {
    const std::size_t count = caches_.point_file_.read_block(
        page, codec_, stored_, std::as_writable_bytes(std::span(block_)));
    loaded.unscale = 1 / caches_.scale_;
    const double s = caches_.scale_;
    for (std::size_t i = 0; i < PointPage::kPoints; ++i) {
      constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
      const bool there = i < count;
      loaded.x[i] = there ? block_[i].point.x * s : kNothing;
      loaded.y[i] = there ? block_[i].point.y * s : kNothing;
      loaded.z[i] = there ? block_[i].point.z * s : kNothing;
      loaded.input_index[i] = there ? block_[i].input_index : 0;
    }
  });
}

const NodePage& IndexReader::nodes(std::uint64_t page) {
  if (page != node_page_) {
    node_pin_ = pin_nodes(page);
    node_page_ = page;
  }
  return *node_pin_;
}

const PointPage& IndexReader::points_at(PointRank rank) {
  const std::uint64_t page = rank / PointPage::kPoints;
  if (page != point_page_) {
    point_pin_ = pin_points(page);
    point_page_ = page;
  }
  return *point_pin_;
}

StoredPoint IndexReader::point(PointRank rank) {
  const PointPage& page = points_at(rank);
  const std::size_t i = rank % PointPage::kPoints;
  return {page.point(i), page.input_index[i]};
}

}  // namespace stream_recon
