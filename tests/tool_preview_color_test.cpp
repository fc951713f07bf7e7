// Colours, components, letters: the parts that give pictures their meaning.

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <set>

#include "tools/preview/coloring.h"
#include "tools/preview/components.h"
#include "tools/preview/lettering.h"
#include "tools/preview/view.h"

namespace stream_recon {
namespace {

TEST(ScaleColor, StepsOfLightnessAreEven) {
  constexpr int kSteps = 20;
  for (int i = 0; i < kSteps; ++i) {
    const double step = lightness_of(scale_color((i + 1.0) / kSteps)) -
                        lightness_of(scale_color(static_cast<double>(i) / kSteps));
    EXPECT_NEAR(step, 0.54 / kSteps, 0.006) << i;
  }
}

TEST(DistinctColor, TheFirstTwelveAreFarApart) {
  for (int i = 0; i < 12; ++i) {
    for (int j = 0; j < i; ++j) {
      const Rgb a = to_bytes(distinct_color(i));
      const Rgb b = to_bytes(distinct_color(j));
      EXPECT_GT(std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]), 40) << i << ' ' << j;
    }
  }
  EXPECT_EQ(distinct_paint(kDistinctCount + 3), distinct_paint(3));
}

TEST(Color, BytesComeBack) {
  for (int i = 0; i < 256; ++i) {
    const auto byte = static_cast<std::uint8_t>(i);
    const Rgb color{byte, static_cast<std::uint8_t>(255 - i), 7};
    EXPECT_EQ(to_bytes(from_bytes(color)), color);
  }
}

TEST(Coloring, IsReadAsWritten) {
  EXPECT_EQ(parse_coloring("Delta").by, ColorBy::kDelta);
  EXPECT_EQ(parse_coloring("Source").by, ColorBy::kSource);
  EXPECT_EQ(parse_coloring("Closure").by, ColorBy::kClosure);
  EXPECT_EQ(parse_coloring("component").by, ColorBy::kComponent);
  EXPECT_EQ(parse_coloring("none").by, ColorBy::kNone);
  EXPECT_EQ(parse_coloring("1,20,255").fixed, (Rgb{1, 20, 255}));
  for (const char* text : {"", "delta", "1,2", "1,2,3,4", "1,2,256", "-1,2,3", "a,b,c", "1;2;3"}) {
    EXPECT_THROW(parse_coloring(text), std::invalid_argument) << text;
  }
}

TEST(Views, AreSeparatedByCommasAsTheirAnglesAre) {
  const auto names = [](const char* text) {
    std::vector<std::string> all;
    for (const NamedView& view : parse_views(text)) all.push_back(view.name);
    return all;
  };
  EXPECT_EQ(names("front"), (std::vector<std::string>{"front"}));
  EXPECT_EQ(names("front,30,-20,top"), (std::vector<std::string>{"front", "30,-20", "top"}));
  for (const char* text : {"", "front,", "front,30", "front,,top", "front,30,top"}) {
    EXPECT_THROW(parse_views(text), std::invalid_argument) << text;
  }
}

TEST(Components, AreThoseOfABruteForceSearch) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    constexpr std::uint64_t kPoints = 60;
    std::vector<std::array<std::uint64_t, 3>> triangles(random() % 30 + 1);
    for (auto& triangle : triangles) {
      do {
        for (auto& corner : triangle) corner = random() % kPoints;
      } while (triangle[0] == triangle[1] || triangle[1] == triangle[2]);
    }
    std::vector<std::uint64_t> label(kPoints);
    for (std::uint64_t i = 0; i < kPoints; ++i) label[i] = i;
    for (std::size_t round = 0; round < triangles.size(); ++round) {
      for (const auto& [a, b, c] : triangles) {
        label[a] = label[b] = label[c] = std::min({label[a], label[b], label[c]});
      }
    }
    std::map<std::uint64_t, std::uint64_t> sizes;
    for (const std::uint64_t l : label) ++sizes[l];
    std::erase_if(sizes, [](const auto& entry) { return entry.second == 1; });

    Components components(kPoints);
    for (const auto& triangle : triangles) components.join(triangle);
    components.rank();
    ASSERT_EQ(components.count(), sizes.size());
    std::map<std::uint64_t, std::uint32_t> ranks;
    for (const auto& triangle : triangles) {
      const std::uint32_t rank = components.rank_of(triangle[0]);
      EXPECT_EQ(components.rank_of(triangle[2]), rank);
      EXPECT_EQ(components.size(rank), sizes[label[triangle[0]]]);
      EXPECT_EQ(ranks.try_emplace(label[triangle[0]], rank).first->second, rank);
    }
    for (std::uint64_t rank = 1; rank < components.count(); ++rank) {
      EXPECT_GE(components.size(rank - 1), components.size(rank));
    }
  }
}

TEST(Lettering, EverySignLooksDifferentAndKeepsToItsPlace) {
  const std::string signs =
      "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz.,-_/:()+=%?";
  std::set<std::vector<std::uint8_t>> shapes;
  for (const char sign : signs) {
    Picture picture(40, 40);
    write_text(picture, std::string(1, sign), {10, 28, 24, {255, 255, 255}});
    std::vector<std::uint8_t> shape;
    for (std::size_t y = 0; y < 40; ++y) {
      for (std::size_t x = 0; x < 40; ++x) {
        shape.push_back(picture.at(x, y)[0]);
        const bool is_edge = x < 8 || y < 10 || y > 34 || x > 26;
        EXPECT_FALSE(is_edge && shape.back() != 0) << sign << ' ' << x << ' ' << y;
      }
    }
    EXPECT_TRUE(shapes.insert(shape).second) << sign;
  }
  EXPECT_GT(text_width("wide", 12), text_width("wid", 12));
}

}  // namespace
}  // namespace stream_recon
