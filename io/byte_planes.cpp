#include "io/byte_planes.h"

#include <array>
#include <cassert>
#include <cstdint>
#include <cstring>

namespace stream_recon {
namespace {

constexpr std::size_t kGroup = 8;  // records whose words are transposed together
using Words = std::array<std::uint64_t, kGroup>;

/// Exchanges the bytes of eight words as the corners of an 8 x 8 matrix: in three steps, halves,
/// quarters, then bytes (Warren, Hacker's Delight, 7-3, for bits).
void transpose_bytes(Words& m) {
  constexpr std::array<std::uint64_t, 3> kLow{0x00000000ffffffff, 0x0000ffff0000ffff,
                                              0x00ff00ff00ff00ff};
  for (std::size_t stage = 0, distance = 4; distance > 0; ++stage, distance /= 2) {
    const std::uint64_t low = kLow[stage];
    const auto bits = static_cast<unsigned>(8 * distance);
    for (std::size_t i = 0; i < kGroup; ++i) {
      if ((i & distance) != 0) continue;
      const std::uint64_t moved = ((m[i] >> bits) ^ m[i + distance]) & low;
      m[i] ^= moved << bits;
      m[i + distance] ^= moved;
    }
  }
}

template <class Word>
Word load(const std::byte* from) {
  Word word;
  std::memcpy(&word, from, sizeof word);
  return word;
}

/// Splits the word at `records` of `count` records into its planes.
template <class Word>
void split_word(const std::byte* records, std::size_t record_bytes, std::size_t count,
                std::byte* planes) {
  std::size_t i = 0;
  for (; i + kGroup <= count; i += kGroup) {
    Words m;
    for (std::size_t j = 0; j < kGroup; ++j) m[j] = load<Word>(records + (i + j) * record_bytes);
    transpose_bytes(m);
    for (std::size_t b = 0; b < sizeof(Word); ++b) std::memcpy(planes + b * count + i, &m[b], 8);
  }
  for (; i < count; ++i) {
    for (std::size_t b = 0; b < sizeof(Word); ++b)
      planes[b * count + i] = records[i * record_bytes + b];
  }
}

/// The inverse of split_word.
template <class Word>
void join_word(const std::byte* planes, std::size_t record_bytes, std::size_t count,
               std::byte* records) {
  std::size_t i = 0;
  for (; i + kGroup <= count; i += kGroup) {
    Words m{};
    for (std::size_t b = 0; b < sizeof(Word); ++b) std::memcpy(&m[b], planes + b * count + i, 8);
    transpose_bytes(m);
    for (std::size_t j = 0; j < kGroup; ++j) {
      const auto word = static_cast<Word>(m[j]);
      std::memcpy(records + (i + j) * record_bytes, &word, sizeof word);
    }
  }
  for (; i < count; ++i) {
    for (std::size_t b = 0; b < sizeof(Word); ++b)
      records[i * record_bytes + b] = planes[b * count + i];
  }
}

}  // namespace

bool can_split_planes(std::size_t record_bytes) {
  return record_bytes != 0 && record_bytes % 4 == 0;
}

void split_planes(std::span<const std::byte> records, std::size_t record_bytes,
                  std::span<std::byte> planes) {
  assert(records.size() == planes.size() && records.size() % record_bytes == 0);
  const std::size_t count = records.size() / record_bytes;
  const bool is_wide = record_bytes % 8 == 0;
  const auto split = is_wide ? split_word<std::uint64_t> : split_word<std::uint32_t>;
  for (std::size_t w = 0; w < record_bytes; w += is_wide ? 8 : 4) {
    split(records.data() + w, record_bytes, count, planes.data() + w * count);
  }
}

void join_planes(std::span<const std::byte> planes, std::size_t record_bytes,
                 std::span<std::byte> records) {
  assert(records.size() == planes.size() && records.size() % record_bytes == 0);
  const std::size_t count = records.size() / record_bytes;
  const bool is_wide = record_bytes % 8 == 0;
  const auto join = is_wide ? join_word<std::uint64_t> : join_word<std::uint32_t>;
  for (std::size_t w = 0; w < record_bytes; w += is_wide ? 8 : 4) {
    join(planes.data() + w * count, record_bytes, count, records.data() + w);
  }
}

}  // namespace stream_recon
