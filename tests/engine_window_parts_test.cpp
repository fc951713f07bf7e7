// What windows are made of: the page cache, the set of present points, the index.
#include <gtest/gtest.h>

#include <random>
#include <set>
#include <vector>

#include "engine/windows/final_simplices.h"
#include "engine/windows/index_layout.h"
#include "engine/windows/page_cache.h"
#include "engine/windows/present_points.h"

namespace stream_recon {
namespace {

using namespace index_layout;

TEST(PageCache, KeepsThePagesUsedLast) {
  PageCache<int> cache(2);
  int loads = 0;
  const auto get = [&](int number) {
    return *cache.get(number, [&](int& page) { page = 10 * number, ++loads; });
  };
  EXPECT_EQ(get(1), 10);
  EXPECT_EQ(get(2), 20);
  EXPECT_EQ(get(1), 10);
  EXPECT_EQ(loads, 2);
  EXPECT_EQ(get(3), 30);  // in place of 2
  EXPECT_EQ(get(1), 10);
  EXPECT_EQ(loads, 3);
  EXPECT_EQ(get(2), 20);
  EXPECT_EQ(loads, 4);
}

TEST(PageCache, KeepsAPinnedPageAsItIs) {
  PageCache<int> cache(1);
  const auto pin = cache.get(1, [](int& page) { page = 1; });
  for (int other = 2; other < 50; ++other) cache.get(other, [](int& page) { page = -1; });
  EXPECT_EQ(*pin, 1);
}

TEST(PageCache, LoadsAgainAfterAFailure) {
  PageCache<int> cache(1);
  EXPECT_THROW(cache.get(1, [](int&) { throw std::runtime_error("unreadable"); }),
               std::runtime_error);
  EXPECT_EQ(*cache.get(1, [](int& page) { page = 7; }), 7);
}

TEST(PresentPoints, AreThoseOfTheirLeavesAndTheSingleOnes) {
  const std::uint64_t seed = 32;
  SCOPED_TRACE(seed);
  std::mt19937_64 random(seed);
  constexpr LeafNumber kLeaves = 1000;
  PresentPoints present(kLeaves);
  for (int run = 0; run < 2; ++run) {
    std::set<LeafNumber> leaves;
    std::set<PointRank> singles;
    for (int i = 0; i < 900; ++i) {
      const LeafNumber leaf = random() % (i < 400 ? kLeaves : 130);
      EXPECT_EQ(present.add_leaf(leaf), leaves.insert(leaf).second);
      const PointRank rank = random() % (kLeaves * kLeafPoints);
      const bool is_new = !leaves.contains(leaf_of(rank)) && singles.insert(rank).second;
      EXPECT_EQ(present.add_single(rank), is_new);
    }
    for (PointRank rank = 0; rank < kLeaves * kLeafPoints; ++rank) {
      ASSERT_EQ(present.has_leaf(leaf_of(rank)), leaves.contains(leaf_of(rank)));
      ASSERT_EQ(present.is_single(rank), singles.contains(rank));
    }
    for (int i = 0; i < 3000; ++i) {
      const LeafNumber begin = random() % 140;
      const LeafNumber end = begin + random() % (i % 2 == 0 ? 140 : 4);
      bool all = true;
      for (LeafNumber leaf = begin; leaf < end; ++leaf) all = all && leaves.contains(leaf);
      ASSERT_EQ(present.has_leaves({begin, end}), all) << begin << " " << end;
    }
    present.clear();
    EXPECT_FALSE(present.has_leaf(*leaves.begin()));
  }
}

TEST(PresentPoints, DoNotMissLeavesBeyondTheEndOfTheCloud) {
  PresentPoints present(70);
  for (LeafNumber leaf = 64; leaf < 70; ++leaf) present.add_leaf(leaf);
  EXPECT_TRUE(present.has_leaves({64, 128}));
  EXPECT_FALSE(present.has_leaves({63, 128}));
}

TEST(FinalWindow, EmitsPartOfACellWithAtMostOneVertexBeforeTheWindow) {
  // Owns ranks 100 .. 103; guests 4, 5 and 6, 7 before and after.
  const std::vector<PointRank> guests{7, 99, 104, 500};
  const FinalWindow window(
      {.first_rank = 100, .owned_count = 4, .guest_ranks = guests, .input_indices = {}});
  constexpr VertexId kInfinite = Delaunay::kInfinite;
  EXPECT_TRUE(emits_part(window, {0, 1, 2, 3}));
  EXPECT_TRUE(emits_part(window, {6, 7, 3, 0}));
  EXPECT_TRUE(emits_part(window, {6, 4, 7, 2}));
  EXPECT_FALSE(emits_part(window, {4, 5, 0, 1}));
  EXPECT_FALSE(emits_part(window, {4, 6, 7, 4}));
  EXPECT_TRUE(emits_part(window, {1, 6, 7, kInfinite}));
  EXPECT_FALSE(emits_part(window, {1, 5, 7, kInfinite}));
  EXPECT_FALSE(emits_part(window, {6, 7, 6, kInfinite}));
}

TEST(IndexLayout, ChildrenCoverTheLeavesOfTheirParent) {
  for (std::uint32_t node = 0; node < kFirstLeaf; ++node) {
    const LeafRange parent = leaves_below(3, node);
    LeafNumber at = parent.begin;
    for (std::uint32_t child = 4 * node + 1; child <= 4 * node + 4; ++child) {
      const LeafRange leaves = leaves_below(3, child);
      EXPECT_EQ(leaves.begin, at);
      at = leaves.end;
    }
    EXPECT_EQ(at, parent.end);
  }
  EXPECT_EQ(leaves_below(3, 0).begin, 3 * kPageLeaves);
  EXPECT_EQ(leaves_below(3, kFirstLeaf).end, 3 * kPageLeaves + 1);
  EXPECT_EQ(leaves_below(3, kPageNodes - 1).end, 4 * kPageLeaves);
}

}  // namespace
}  // namespace stream_recon
