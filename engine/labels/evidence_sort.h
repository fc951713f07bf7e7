// Brings edges into the order in which a forest takes them.
//
// Guarantees: as std::sort by comes_before(). Thread rule: one thread. Memory: none but the stack,
// 60 KB at most: edges change places where they lie. Cost: linear, about 60 ns an edge, however
// many weights are equal.
// Source: McIlroy, Bostic, McIlroy, Engineering Radix Sort, Computing Systems 6, 1993, with digits
// cut to the range of the keys.
#pragma once

#include <span>

#include "engine/labels/evidence_records.h"

namespace stream_recon {

/// \pre Weights are finite and not negative.
void sort_evidence(std::span<EvidenceEdge> edges);

}  // namespace stream_recon
