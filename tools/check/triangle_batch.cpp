#include "tools/check/triangle_batch.h"

#include <algorithm>
#include <limits>

namespace stream_recon {
namespace {

/// The finalizer of splitmix64.
std::uint64_t mixed(std::uint64_t x) {
  x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9;
  x = (x ^ x >> 27) * 0x94d049bb133111eb;
  return x ^ x >> 31;
}

}  // namespace

TriangleBatch::TriangleBatch() : slots_(kSlots) {
  entries_.reserve(kTriangles);
  vertices_.reserve(3 * kTriangles);
  parents_.reserve(3 * kTriangles);
}

std::uint32_t TriangleBatch::position_of(std::uint64_t vertex) {
  for (std::size_t at = mixed(vertex) % kSlots;; at = (at + 1) % kSlots) {
    if (slots_[at] == 0) {
      vertices_.push_back(vertex);
      parents_.push_back(static_cast<std::uint32_t>(parents_.size()));
      slots_[at] = static_cast<std::uint32_t>(vertices_.size());
    }
    if (vertices_[slots_[at] - 1] == vertex) return slots_[at] - 1;
  }
}

std::uint32_t TriangleBatch::root_of(std::uint32_t position) {
  while (parents_[position] != position) {
    parents_[position] = parents_[parents_[position]];
    position = parents_[position];
  }
  return position;
}

void TriangleBatch::add(const MeshTriangle& corners, double volume) {
  const std::uint32_t first = position_of(corners[0]);
  for (std::size_t i = 1; i < 3; ++i) {
    const std::uint32_t a = root_of(first);
    const std::uint32_t b = root_of(position_of(corners[i]));
    parents_[std::max(a, b)] = std::min(a, b);
  }
  entries_.push_back({corners, volume, first});
}

std::uint32_t TriangleBatch::number_pieces() {
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> numbers(parents_.size(), kNone);
  std::uint32_t pieces = 0;
  for (Entry& entry : entries_) {
    std::uint32_t& number = numbers[root_of(entry.piece)];
    if (number == kNone) number = pieces++;
    entry.piece = number;
  }
  return pieces;
}

void TriangleBatch::clear() {
  entries_.clear();
  vertices_.clear();
  parents_.clear();
  std::fill(slots_.begin(), slots_.end(), 0);
}

}  // namespace stream_recon
