#include "spatial/simplex_digest.h"

#include <gtest/gtest.h>

namespace stream_recon {
namespace {

TEST(SimplexDigest, splitmix64_has_the_published_first_values) {
  EXPECT_EQ(SimplexDigest::splitmix64(0), 0xe220a8397b1dcdafU);
  EXPECT_EQ(SimplexDigest::splitmix64(0x9e3779b97f4a7c15U), 0x6e789e6aa1b965f4U);
}

TEST(SimplexDigest, does_not_depend_on_the_order_of_vertices_and_simplices) {
  SimplexDigest forward;
  forward.add<4>({1, 2, 3, 4});
  forward.add<4>({7, 2, 9, 4});
  SimplexDigest backward;
  backward.add<4>({9, 7, 4, 2});
  backward.add<4>({4, 3, 2, 1});
  EXPECT_EQ(forward.hex(), backward.hex());
}

TEST(SimplexDigest, parts_add_up) {
  SimplexDigest whole;
  whole.add<3>({1, 2, 3});
  whole.add<3>({2, 3, 4});
  SimplexDigest first;
  first.add<3>({1, 2, 3});
  SimplexDigest second;
  second.add<3>({2, 3, 4});
  first.merge(second);
  EXPECT_EQ(first.value(), whole.value());
}

TEST(SimplexDigest, tells_apart_what_differs_in_one_vertex) {
  SimplexDigest one;
  one.add<4>({0, 1, 2, 3});
  SimplexDigest other;
  other.add<4>({0, 1, 2, 4});
  EXPECT_NE(one.value(), other.value());
}

TEST(SimplexDigest, is_sixteen_hex_digits) {
  EXPECT_EQ(SimplexDigest().hex(), "0000000000000000");
  SimplexDigest digest;
  digest.add<1>({0});
  EXPECT_EQ(digest.hex(), "e220a8397b1dcdaf");
}

}  // namespace
}  // namespace stream_recon
