// Labels of poles from their links, on graphs whose labels are plain to see.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

#include "tests/benchmarks/pole_links.h"

namespace stream_recon {
namespace {

using enum LinkLabel;
using Labels = std::vector<LinkLabel>;

const std::vector<std::uint32_t> kOutsideFirst{0};

TEST(PoleLinks, HandLabelsOnAsTheSameAndAsOppositeAsFarAsTheyReach) {
  const std::vector<PoleLink> links{{0, 1, 0.9, true}, {2, 1, 0.8, false}, {3, 4, 1, true}};
  const Labels expected{kOutside, kInside, kInside, kNone, kNone};
  EXPECT_EQ(priority_labels(5, links, kOutsideFirst), expected);
  EXPECT_EQ(forest_labels(5, links, kOutsideFirst), expected);
}

TEST(PoleLinks, BelieveTheSurerOfTwo) {
  const std::vector<PoleLink> links{{1, 2, 0.5, false}, {0, 1, 0.8, true}, {0, 2, 0.9, false}};
  const Labels expected{kOutside, kInside, kOutside};
  EXPECT_EQ(priority_labels(3, links, kOutsideFirst), expected);
  EXPECT_EQ(forest_labels(3, links, kOutsideFirst), expected);
}

TEST(PoleLinks, OfPriorityWeakenAlongTheWayThoseOfTheForestDoNot) {
  std::vector<PoleLink> links{{0, 8, 0.5, true}};
  for (std::uint32_t p = 0; p < 8; ++p) links.push_back({p, p + 1, 0.9, false});
  EXPECT_EQ(priority_labels(9, links, kOutsideFirst)[8], kInside);
  EXPECT_EQ(forest_labels(9, links, kOutsideFirst)[8], kOutside);
}

/// By walks along the links taken so far.
Labels forest_by_walking(std::uint32_t poles, std::vector<PoleLink> links) {
  std::sort(links.begin(), links.end(),
            [](const PoleLink& a, const PoleLink& b) { return a.weight > b.weight; });
  std::vector<PoleLink> taken;
  const auto labels_from = [&](std::uint32_t start) {
    Labels labels(poles, kNone);
    labels[start] = kOutside;
    for (std::uint32_t round = 0; round < poles; ++round) {
      for (const PoleLink& link : taken) {
        for (const auto& [a, b] : {std::pair(link.a, link.b), std::pair(link.b, link.a)}) {
          if (labels[a] == kNone || labels[b] != kNone) continue;
          labels[b] = (labels[a] == kInside) != link.is_opposite ? kInside : kOutside;
        }
      }
    }
    return labels;
  };
  for (const PoleLink& link : links)
    if (labels_from(link.a)[link.b] == kNone) taken.push_back(link);
  return labels_from(0);
}

TEST(PoleLinks, ForestIsThatOfWalks) {
  constexpr std::uint32_t kPoles = 25;
  std::mt19937_64 random(3);
  std::uniform_int_distribution<std::uint32_t> pole(0, kPoles - 1);
  std::uniform_real_distribution<double> weight(0, 1);
  for (int round = 0; round < 20; ++round) {
    std::vector<PoleLink> links(20 + 3 * round);
    for (PoleLink& link : links)
      link = {pole(random), pole(random), weight(random), round % 3 == 0};
    for (std::size_t i = 0; i < links.size(); i += 2) links[i].is_opposite = true;
    EXPECT_EQ(forest_labels(kPoles, links, kOutsideFirst), forest_by_walking(kPoles, links));
  }
}

}  // namespace
}  // namespace stream_recon
