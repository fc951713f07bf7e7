// The pages of the index and of the store that one thread is at work on, kept within reach.
//
// Guarantees: as engine/windows/index_reader.h, but a page stays valid until another page of the
// same place is asked for: pages have places by their number, modulo kPlaces.
// Thread rule: one thread's. Memory: kMemory, beside the caches. Cost: about 1 ns for a page that
// is in its place, that of the cache for others.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "engine/windows/index_reader.h"

namespace stream_recon {

class PinnedPages {
 public:
  static constexpr std::size_t kPlaces = 16;
  static constexpr std::uint64_t kMemory = kPlaces * (sizeof(NodePage) + sizeof(PointPage));

  explicit PinnedPages(IndexReader& reader) : reader_(reader) {}

  /// \throw IoError
  const NodePage& nodes(std::uint64_t page) {
    auto& place = nodes_[page % kPlaces];
    if (place.number != page) place = {page, reader_.pin_nodes(page)};
    return *place.pin;
  }

  /// The page that has a rank. \throw IoError
  const PointPage& points_at(PointRank rank) {
    const std::uint64_t page = rank / PointPage::kPoints;
    auto& place = points_[page % kPlaces];
    if (place.number != page) place = {page, reader_.pin_points(page)};
    return *place.pin;
  }

 private:
  template <class Page>
  struct Place {
    std::uint64_t number = std::numeric_limits<std::uint64_t>::max();
    typename PageCache<Page>::Pin pin;
  };

  IndexReader& reader_;
  std::array<Place<NodePage>, kPlaces> nodes_;
  std::array<Place<PointPage>, kPlaces> points_;
};

}  // namespace stream_recon
