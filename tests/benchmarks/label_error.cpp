#include "tests/benchmarks/label_error.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

#include "tools/clouds/random.h"

namespace stream_recon {
namespace {

struct Ray {
  double y, z;
};

Ray ray_of(std::int32_t z, std::int32_t y, double cell) {
  const auto high = static_cast<std::uint64_t>(static_cast<std::uint32_t>(z)) << 32;
  Random random(SimplexDigest::splitmix64(high | static_cast<std::uint32_t>(y)));
  const double across = y + random.unit();
  return {across * cell, (z + random.unit()) * cell};
}

std::int32_t cell_of(double coordinate, double cell) {
  return static_cast<std::int32_t>(std::floor(coordinate / cell));
}

/// Twice the area of a, b and the ray, exactly the opposite for b and a, so that triangles on both
/// sides of an edge agree on which side of it the ray is.
double turn(Point3 a, Point3 b, const Ray& ray) {
  const bool is_swapped = b < a;
  if (is_swapped) std::swap(a, b);
  const double twice = (a.y - ray.y) * (b.z - ray.z) - (a.z - ray.z) * (b.y - ray.y);
  return is_swapped ? -twice : twice;
}

/// Where the ray meets the triangle.
std::optional<double> meet(const std::array<Point3, 3>& corners, const Ray& ray) {
  const auto& [a, b, c] = corners;
  const double of_a = turn(b, c, ray);
  const double of_b = turn(c, a, ray);
  const double of_c = turn(a, b, ray);
  const bool is_left = of_a > 0 && of_b > 0 && of_c > 0;
  const bool is_right = of_a < 0 && of_b < 0 && of_c < 0;
  if (!is_left && !is_right) return std::nullopt;
  return (of_a * a.x + of_b * b.x + of_c * c.x) / (of_a + of_b + of_c);
}

/// Of the parts of a line from every other one of its sorted ends to the next.
double covered_length(const std::vector<double>& ends) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < ends.size(); i += 2) sum += ends[i + 1] - ends[i];
  return sum;
}

}  // namespace

void LabelErrorMeter::add_triangle(const std::array<Point3, 3>& corners) {
  const auto [low_y, high_y] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
  const auto [low_z, high_z] = std::minmax({corners[0].z, corners[1].z, corners[2].z});
  for (std::int32_t z = cell_of(low_z, cell_); z <= cell_of(high_z, cell_); ++z) {
    for (std::int32_t y = cell_of(low_y, cell_); y <= cell_of(high_y, cell_); ++y) {
      if (const auto x = meet(corners, ray_of(z, y, cell_))) crossings_.push_back({z, y, *x});
    }
  }
}

// A ray that the mesh does not meet has a mark at the very beginning, and so has every other one.
void LabelErrorMeter::add_solid_rays() {
  const std::int32_t end = cell_of(solid_.reach(), cell_) + 1;
  for (std::int32_t z = -end; z < end; ++z) {
    for (std::int32_t y = -end; y < end; ++y)
      crossings_.push_back({z, y, -std::numeric_limits<double>::infinity()});
  }
}

LabelError LabelErrorMeter::measure() {
  add_solid_rays();
  std::sort(crossings_.begin(), crossings_.end(), [](const Crossing& a, const Crossing& b) {
    return std::tie(a.z, a.y, a.x) < std::tie(b.z, b.y, b.x);
  });
  LabelError sum;
  for (auto first = crossings_.begin(); first != crossings_.end();) {
    const auto last = std::find_if(first, crossings_.end(), [&](const Crossing& other) {
      return other.z != first->z || other.y != first->y;
    });
    measure_ray({first, last}, sum);
    first = last;
  }
  return sum;
}

void LabelErrorMeter::measure_ray(std::span<const Crossing> crossings, LabelError& sum) const {
  std::vector<double> mesh;
  for (const Crossing& crossing : crossings)
    if (std::isfinite(crossing.x)) mesh.push_back(crossing.x);
  const std::vector<double> solid = solid_crossings(crossings.front().z, crossings.front().y);
  sum.rays += !mesh.empty() || !solid.empty() ? 1 : 0;
  const double cell_area = cell_ * cell_;
  sum.solid_volume += covered_length(solid) * cell_area;
  if (mesh.size() % 2 != 0) {
    ++sum.odd_rays;
    return;
  }
  std::vector<double> both;
  std::merge(mesh.begin(), mesh.end(), solid.begin(), solid.end(), std::back_inserter(both));
  sum.mesh_volume += covered_length(mesh) * cell_area;
  sum.wrong_volume += covered_length(both) * cell_area;
}

std::vector<double> LabelErrorMeter::solid_crossings(std::int32_t z, std::int32_t y) const {
  const Ray ray = ray_of(z, y, cell_);
  const auto bound = [&](double x) { return solid_.signed_bound({x, ray.y, ray.z}); };
  const auto crossing = [&](double a, double b, bool a_inside) {
    for (int round = 0; round < 30; ++round) {
      const double middle = (a + b) / 2;
      ((bound(middle) < 0) == a_inside ? a : b) = middle;
    }
    return (a + b) / 2;
  };
  std::vector<double> ends;
  bool inside = false;
  double before = -solid_.reach() - cell_;
  for (double x = before; x < solid_.reach() + 2 * cell_;) {
    const double clear = bound(x);
    if ((clear < 0) != inside) {
      ends.push_back(crossing(before, x, inside));
      inside = !inside;
    }
    before = std::exchange(x, x + std::max(std::abs(clear), cell_ / 4));
  }
  return ends;
}

}  // namespace stream_recon
