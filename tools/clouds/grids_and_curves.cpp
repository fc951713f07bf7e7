#include "tools/clouds/grids_and_curves.h"

#include "tools/clouds/trigonometry.h"

namespace stream_recon {
namespace {

double fraction(std::uint64_t index, std::uint64_t count) {
  return static_cast<double>(index) / static_cast<double>(count);
}

}  // namespace

GridBlock::GridBlock(std::uint64_t count) : side_(1) {
  while (side_ * side_ * side_ < count) ++side_;
}

Point3 GridBlock::point(std::uint64_t index) const {
  const std::uint64_t row = index / side_;
  const std::uint64_t layer = row / side_;
  return {static_cast<double>(index % side_), static_cast<double>(row % side_),
          static_cast<double>(layer)};
}

Point3 collinear_point(Random& random) {
  const double t = static_cast<double>(random.bits() >> 13) * 0x1p-51;  // 3 t is exact
  return {t, 2 * t, 3 * t};
}

Point3 coplanar_point(Random& random) {
  const double x = static_cast<double>(random.bits() >> 12) * 0x1p-52;  // x + y is exact
  const double y = static_cast<double>(random.bits() >> 12) * 0x1p-52;
  return {x, y, x + y};
}

Point3 circle_point(std::uint64_t index, std::uint64_t count) {
  const SineCosine turn = sine_cosine(2 * kPi * fraction(index, count));
  return {turn.cosine, turn.sine, 0};
}

Point3 helix_point(std::uint64_t index, std::uint64_t count) {
  const double t = fraction(index, count);
  const SineCosine turn = sine_cosine(8 * 2 * kPi * t);
  return {turn.cosine, turn.sine, 4 * t};
}

Point3 skew_lines_point(std::uint64_t index, std::uint64_t count) {
  const double t = 2 * fraction(index / 2, count);
  if (index % 2 == 0) return {t, 0.5, 0};
  return {0.5, t, 1};
}

}  // namespace stream_recon
