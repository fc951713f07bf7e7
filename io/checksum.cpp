#include "io/checksum.h"

#include <array>
#include <bit>
#include <cstring>

namespace stream_recon {
namespace {

static_assert(std::endian::native == std::endian::little, "words are read as little endian");

constexpr std::uint64_t kOdd = 0x9e3779b97f4a7c15;
constexpr std::uint64_t kOtherOdd = 0xd6e8feb86659fd93;

/// A bijection of lane and of word, so that a changed word always changes its lane. The word is
/// multiplied too: else a changed top bit could be undone by one changed bit of the next word.
std::uint64_t step(std::uint64_t lane, std::uint64_t word) {
  return std::rotl(lane ^ word * kOdd, 29) * kOtherOdd;
}

/// The finalizer of splitmix64 (Steele, Lea, Flood, OOPSLA 2014), a bijection.
std::uint64_t finish(std::uint64_t x) {
  x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9;
  x = (x ^ x >> 27) * 0x94d049bb133111eb;
  return x ^ x >> 31;
}

}  // namespace

std::uint64_t checksum64(std::span<const std::byte> data, std::uint64_t seed) {
  // Four lanes hide the latency of the multiplication.
  std::array<std::uint64_t, 4> lanes{seed, seed + 1 * kOdd, seed + 2 * kOdd, seed + 3 * kOdd};
  std::array<std::uint64_t, 4> words{};
  const std::size_t size = data.size();
  for (; data.size() >= sizeof words; data = data.subspan(sizeof words)) {
    std::memcpy(words.data(), data.data(), sizeof words);
    for (std::size_t i = 0; i < lanes.size(); ++i) lanes[i] = step(lanes[i], words[i]);
  }
  words.fill(0);
  if (!data.empty()) std::memcpy(words.data(), data.data(), data.size());
  for (std::size_t i = 0; i < lanes.size(); ++i) lanes[i] = step(lanes[i], words[i]);
  std::uint64_t sum = finish(size ^ seed);
  for (const std::uint64_t lane : lanes) sum = finish(sum ^ lane);
  return sum;
}

}  // namespace stream_recon
