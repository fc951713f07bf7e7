// Holes as the search left them, one after the other, with the crust near them and the facets
// beside them where these are there.
//
// Thread rule: a reader belongs to one thread. Memory: HoleReader::memory(), and about bytes() a
// hole that was read.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/hybrid/crust_piece.h"
#include "engine/hybrid/hole.h"
#include "engine/hybrid/hole_group.h"

namespace stream_recon {

struct StoredHole {
  std::uint32_t number = 0;
  std::vector<std::uint32_t> ranks;  ///< of hole.points
  std::vector<HoleFill> records;     ///< of hole.fills
  Hole hole;
  CrustPiece crust;

  std::uint64_t bytes() const;
};

class HoleReader {
 public:
  /// \pre find_holes() has been called.
  /// \param has_surroundings whether holes come with the crust near them and the facets beside
  /// them: build_hole_crust() and store_outer_facets() have been called
  /// \throw IoError
  HoleReader(const ScratchDirectory& scratch, bool has_surroundings);

  static constexpr std::uint64_t memory() {
    return HoleGroups<HoleFill>::memory() + HoleGroups<HolePoint>::memory() +
           HoleGroups<HoleCrust>::memory() + HoleGroups<OuterFacet>::memory();
  }

  /// The number of the next hole; nothing at the end. \throw IoError
  std::optional<std::uint32_t> next() { return fills_.next_hole(); }
  /// \pre next() tells a number; that is the hole. \throw IoError
  StoredHole read();
  /// Passes it over. \throw IoError
  void skip();

 private:
  void read_crust(StoredHole& stored);
  void read_outer_facets(StoredHole& stored);

  HoleGroups<HoleFill> fills_;
  HoleGroups<HolePoint> points_;
  std::optional<HoleGroups<HoleCrust>> crust_;
  std::optional<HoleGroups<OuterFacet>> outer_;
};

}  // namespace stream_recon
