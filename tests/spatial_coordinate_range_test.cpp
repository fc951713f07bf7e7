#include "spatial/coordinate_range.h"

#include <gtest/gtest.h>

namespace stream_recon {
namespace {

CoordinateRange range_of(std::initializer_list<double> values) {
  CoordinateRange range;
  for (const double value : values) range.extend(value);
  return range;
}

TEST(CoordinateRange, finds_the_last_and_the_first_bit) {
  const CoordinateRange range = range_of({12, -0.75, 0, 1});
  EXPECT_EQ(range.unit_exponent, -2);
  EXPECT_EQ(range.magnitude_exponent, 4);
  EXPECT_TRUE(range.is_safe());
}

TEST(CoordinateRange, is_empty_for_zeros_alone) {
  EXPECT_TRUE(range_of({0, -0.0}).empty());
  EXPECT_TRUE(range_of({0, -0.0}).is_safe());
}

TEST(CoordinateRange, merges_to_the_range_of_the_whole) {
  CoordinateRange first = range_of({0.5});
  first.merge(range_of({1024}));
  EXPECT_EQ(first.unit_exponent, -1);
  EXPECT_EQ(first.magnitude_exponent, 11);
  first.merge(CoordinateRange());
  EXPECT_EQ(first.unit_exponent, -1);
}

TEST(CoordinateRange, scales_denormals_and_giants_into_the_safe_range) {
  for (const double value : {5e-324, 1e-310, 1e-300, 1e200, 1.7e308}) {
    const CoordinateRange range = range_of({value, 3 * (value / 4)});
    EXPECT_FALSE(range.is_safe()) << value;
    ASSERT_TRUE(range.scale().has_value()) << value;
    const double scaled = value * *range.scale();
    EXPECT_EQ(scaled / *range.scale(), value);
    EXPECT_TRUE(range_of({scaled}).is_safe()) << value;
  }
}

TEST(CoordinateRange, refuses_what_no_scale_brings_together) {
  EXPECT_FALSE(range_of({1e-300, 1}).scale().has_value());
  EXPECT_FALSE(range_of({5e-324, 1.7e308}).scale().has_value());
  EXPECT_TRUE(range_of({1e-30, 1e30}).is_safe());
}

TEST(CoordinateRange, counts_weights_as_squares) {
  CoordinateRange range;
  range.extend(WeightedPoint3{{1, 1, 1}, 0x1p-7});
  EXPECT_EQ(range.unit_exponent, -4);
  range.extend(WeightedPoint3{{1, 1, 1}, 0x1p8});
  EXPECT_EQ(range.magnitude_exponent, 5);
}

}  // namespace
}  // namespace stream_recon
