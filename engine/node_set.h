// Some of the nodes 0 ... size() - 1, and the position of each among them.
//
// Thread rule: one thread while nodes are added, then const for many. Memory: 2 bits a node.
// Cost: constant.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cstdint>
#include <vector>

namespace stream_recon {

class NodeSet {
 public:
  explicit NodeSet(std::uint32_t size) : size_(size), words_(words_for(size)) {}

  static constexpr std::uint64_t memory(std::uint64_t nodes) {
    return words_for(nodes) * sizeof(Word);
  }

  void insert(std::uint32_t node) {
    assert(node < size_);
    words_[node / kBits].bits |= std::uint64_t{1} << node % kBits;
  }
  /// Forgets the nodes from `size` on. \pre None of them is in the set
  void shrink(std::uint32_t size) {
    assert(size <= size_);
    size_ = size;
    words_.resize(words_for(size));
  }
  /// No more nodes.
  void number() {
    count_ = 0;
    for (Word& word : words_) {
      word.before = count_;
      count_ += count_bits(word.bits);
    }
  }

  /// Calls visit(node) for those in the set, ascending.
  template <class Visit>
  void for_each(const Visit& visit) const {
    for (std::uint32_t word = 0; word < words_.size(); ++word) {
      for (std::uint64_t bits = words_[word].bits; bits != 0; bits &= bits - 1) {
        visit(static_cast<std::uint32_t>(word * kBits) +
              static_cast<std::uint32_t>(std::countr_zero(bits)));
      }
    }
  }

  /// The same, and calls prepare(node) some visits before: time for memory to come.
  template <class Prepare, class Visit>
  void for_each(const Prepare& prepare, const Visit& visit) const {
    constexpr std::uint32_t kAhead = 16;
    std::array<std::uint32_t, kAhead> next;
    std::uint32_t prepared = 0;
    for_each([&](std::uint32_t node) {
      prepare(node);
      std::uint32_t& place = next[prepared++ % kAhead];
      if (prepared > kAhead) visit(place);
      place = node;
    });
    for (std::uint32_t left = std::min(prepared, kAhead); left != 0; --left) {
      visit(next[(prepared - left) % kAhead]);
    }
  }

  /// Of nodes in the set and not.
  std::uint32_t size() const { return size_; }
  bool contains(std::uint32_t node) const {
    assert(node < size_);
    return (words_[node / kBits].bits >> node % kBits & 1) != 0;
  }
  /// How many are in the set. \pre number()
  std::uint32_t count() const { return count_; }
  /// How many with a lower number are in the set. \pre number()
  std::uint32_t position(std::uint32_t node) const {
    assert(node < size_);
    const Word& word = words_[node / kBits];
    const std::uint64_t below = (std::uint64_t{1} << node % kBits) - 1;
    return word.before + count_bits(word.bits & below);
  }

 private:
  static constexpr std::uint64_t kBits = 64;

  /// Nodes one after the other.
  struct Word {
    std::uint64_t bits = 0;
    std::uint32_t before = 0;  ///< how many of those in earlier words are in the set
  };

  /// As std::popcount, which is a call where the machine need not have an instruction for it.
  static constexpr std::uint32_t count_bits(std::uint64_t bits) {
    bits -= bits >> 1 & 0x5555555555555555;
    bits = (bits & 0x3333333333333333) + (bits >> 2 & 0x3333333333333333);
    bits = (bits + (bits >> 4)) & 0x0f0f0f0f0f0f0f0f;
    return static_cast<std::uint32_t>(bits * 0x0101010101010101 >> 56);
  }

  static constexpr std::uint64_t words_for(std::uint64_t nodes) {
    return (nodes + kBits - 1) / kBits;
  }

  std::uint32_t size_;
  std::uint32_t count_ = 0;
  std::vector<Word> words_;
};

}  // namespace stream_recon
