// Turns the triangles of a chunk so that neighbours agree, where the surface allows it.
//
// Guarantees: two triangles that share an edge with no third one run along it in opposite
// directions, unless their component is one-sided (a Moebius strip): then some neighbours must
// disagree, which ones depends on the triangles alone. A component that has facets of the convex
// hull faces outward by their majority; any other keeps the order of its first triangle, so
// components and chunks may face different ways. Thread rule: a pure function.
// Memory: 5 bytes a triangle. Source: union-find with parity, after Tarjan 1975.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/surface/edge_uses.h"
#include "engine/surface/facet_record.h"

namespace stream_recon {

/// For each triangle whether it must be reversed.
/// \param uses of all triangles, sorted
/// \param facing of each triangle in ascending order
std::vector<bool> reversals(std::span<const EdgeUse> uses, std::span<const Facing> facing);

/// Whether each triangle must be reversed to face outward. \pre None is unknown.
std::vector<bool> turned_outward(std::span<const Facing> facing);

}  // namespace stream_recon
