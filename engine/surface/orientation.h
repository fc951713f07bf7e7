// Turns the triangles of a chunk so that neighbours agree, where the surface allows it.
//
// Guarantees: two triangles that share an edge with no third one run along it in opposite
// directions, unless their component is one-sided (a Moebius strip): then some neighbours must
// disagree, which ones depends on the triangles alone. A component that has facets of the convex
// hull faces outward by their majority; any other keeps the order of its first triangle, so
// components and chunks may face different ways. The triangles of a solid, whose facing is known,
// need no neighbours: each is turned by its own, outward. Thread rule: pure functions.
// Memory: 9 bytes a triangle. Source: union-find with parity, after Tarjan 1975.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/surface/edge_uses.h"
#include "engine/surface/facet_record.h"

namespace stream_recon {

struct Orientation {
  std::vector<bool> reversed;  ///< whether each triangle must be
  /// Of each the lowest triangle that it hangs together with through edges of two triangles.
  std::vector<std::uint32_t> component;
};

/// \param uses of all triangles, sorted
/// \param facing of each triangle in ascending order
Orientation orient(std::span<const EdgeUse> uses, std::span<const Facing> facing);

/// Whether each triangle must be reversed to face outward. \pre None is unknown.
std::vector<bool> turned_outward(std::span<const Facing> facing);

}  // namespace stream_recon
