#include "spatial/wide_integer.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <random>

namespace stream_recon {
namespace {

using Reference = boost::multiprecision::cpp_int;

constexpr std::uint64_t kSeed = 31;
constexpr int kRounds = 20000;

// Integers of all sizes up to 2^bits, as doubles; often powers of two and their neighbours.
double draw(std::mt19937_64& random, int bits) {
  const int size = static_cast<int>(random() % static_cast<unsigned>(bits + 1));
  double value = std::trunc(std::ldexp(static_cast<double>(random() >> 11), size - 53));
  if (random() % 4 == 0) value = std::ldexp(1.0, size) - static_cast<double>(random() % 2);
  return random() % 2 == 0 ? value : -value;
}

TEST(WideInteger, knows_the_sign_of_what_it_was_made_of) {
  EXPECT_EQ(WideInteger<1>::of(0).sign(), 0);
  EXPECT_EQ(WideInteger<1>::of(-0.0).sign(), 0);
  EXPECT_EQ(WideInteger<2>::of(-1).sign(), -1);
  EXPECT_EQ(WideInteger<2>::of(0x1p126).sign(), 1);
  EXPECT_EQ(WideInteger<7>::of(-0x1p440).sign(), -1);
}

TEST(WideInteger, differences_of_products_have_the_sign_of_unlimited_arithmetic) {
  SCOPED_TRACE(kSeed);
  std::mt19937_64 random(kSeed);
  for (int round = 0; round < kRounds; ++round) {
    const double a = draw(random, 120);
    const double b = draw(random, 60);
    const double c = draw(random, 120);
    const double d = draw(random, 60);
    const auto wide = WideInteger<2>::of(a) * WideInteger<1>::of(b) -
                      WideInteger<1>::of(d) * WideInteger<2>::of(c);
    const Reference exact = Reference(a) * Reference(b) - Reference(c) * Reference(d);
    ASSERT_EQ(wide.sign(), exact.sign()) << a << " " << b << " " << c << " " << d;
  }
}

// (a + b)(a - b) = a^2 - b^2, to the last bit; and one more or less is seen.
TEST(WideInteger, identities_hold_to_the_last_bit) {
  SCOPED_TRACE(kSeed);
  std::mt19937_64 random(kSeed);
  for (int round = 0; round < kRounds; ++round) {
    const auto a = WideInteger<3>::of(draw(random, 188));
    const auto b = WideInteger<3>::of(draw(random, 188));
    const auto left = (a + b) * (a - b);
    const auto right = a * a - b * b;
    ASSERT_EQ((left - right).sign(), 0);
    ASSERT_EQ((left - (right + WideInteger<1>::of(1))).sign(), -1);
    ASSERT_EQ((left - (right - WideInteger<1>::of(1))).sign(), 1);
  }
}

TEST(WideInteger, sums_of_different_widths_extend_the_sign) {
  SCOPED_TRACE(kSeed);
  std::mt19937_64 random(kSeed);
  for (int round = 0; round < kRounds; ++round) {
    const double a = draw(random, 300);
    const double b = draw(random, 62);
    const Reference exact = Reference(a) + Reference(b);
    ASSERT_EQ((WideInteger<5>::of(a) + WideInteger<1>::of(b)).sign(), exact.sign());
    ASSERT_EQ((WideInteger<1>::of(b) + WideInteger<5>::of(a)).sign(), exact.sign());
    ASSERT_EQ(((WideInteger<1>::of(b) - WideInteger<5>::of(a)) + WideInteger<5>::of(a) -
               WideInteger<1>::of(b))
                  .sign(),
              0);
  }
}

}  // namespace
}  // namespace stream_recon
