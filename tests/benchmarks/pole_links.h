// Labels of poles from what joins them, in core: in two ways, to compare the program's with.
//
// Priority, the way of the power crust's authors: each pole has two values, how surely it is inside
// and how surely outside, at first 0. The surest pole that has no label yet takes that of its
// larger value, and hands the value on, times the weight of the link: to its neighbours as the
// same, to the poles opposite as the other one. A pole with one value is as sure as that; with
// both, as they differ, less 1, so that it waits. Forest: the links by falling weight, those that
// would close a cycle passed over; the label is the parity of opposite links on the way to the
// outside. Guarantees: functions of the arguments; of equally sure poles the lowest goes first, of
// equal links the first. Thread rule: pure. Memory: 40 bytes a link, 60 a pole. Cost: 0.2 us a
// link. Source: Amenta, Choi, Kolluri, The power crust, 2001, section 4; docs/algorithms/labels.md.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace stream_recon {

struct PoleLink {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  double weight = 0;  ///< above 0, at most 1
  bool is_opposite = false;
};

enum class LinkLabel : std::uint8_t { kNone, kInside, kOutside };

/// \param outside poles that are surely outside. \return kNone for poles that no label has reached
std::vector<LinkLabel> priority_labels(std::uint32_t poles, std::span<const PoleLink> links,
                                       std::span<const std::uint32_t> outside);

std::vector<LinkLabel> forest_labels(std::uint32_t poles, std::span<const PoleLink> links,
                                     std::span<const std::uint32_t> outside);

}  // namespace stream_recon
