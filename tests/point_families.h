// Families of points that are hard for geometric predicates, for tests.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "spatial/point.h"

namespace stream_recon::families {

inline Point3 random_point(std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  return {uniform(random), uniform(random), uniform(random)};
}

inline Point3 lattice_point(std::mt19937_64& random, int size, double spacing) {
  std::uniform_int_distribution<int> uniform(-size, size);
  return {spacing * uniform(random), spacing * uniform(random), spacing * uniform(random)};
}

// By one unit in the last place; around zero by that of the numbers near 1.
inline double nudged(double value, std::mt19937_64& random) {
  const double step = value == 0 ? 0x1p-53 : std::nextafter(value, 1e300) - value;
  return value + step * (static_cast<int>(random() % 3) - 1);
}

inline Point3 nudged(const Point3& p, std::mt19937_64& random) {
  return {nudged(p.x, random), nudged(p.y, random), nudged(p.z, random)};
}

// A rational point of the unit sphere times a power of two: exactly cospherical where it is exact.
inline Point3 sphere_point(std::mt19937_64& random) {
  static constexpr double kTriples[][3] = {{2, 3, 6}, {6, 10, 15}, {1, 2, 2},
                                           {4, 4, 7}, {2, 6, 9},   {6, 6, 7}};
  static constexpr double kRadius[] = {7, 19, 3, 9, 11, 11};
  const auto kind = random() % 6;
  const double factor = 3 * 7 * 9 * 11 * 19 / kRadius[kind];
  double c[3] = {kTriples[kind][0] * factor, kTriples[kind][1] * factor,
                 kTriples[kind][2] * factor};
  std::shuffle(c, c + 3, random);
  for (double& v : c) v = random() % 2 ? v : -v;
  return {c[0], c[1], c[2]};
}

struct Family {
  std::string name;
  Point3 (*draw)(std::mt19937_64&);
};

inline const std::vector<Family>& all() {
  static const std::vector<Family> kFamilies = {
      {"random", random_point},
      {"small lattice", [](std::mt19937_64& r) { return lattice_point(r, 2, 1); }},
      {"lattice", [](std::mt19937_64& r) { return lattice_point(r, 300, 0.25); }},
      {"beyond doubles in sphere", [](std::mt19937_64& r) { return lattice_point(r, 330, 1); }},
      {"wide lattice", [](std::mt19937_64& r) { return lattice_point(r, 1 << 23, 0x1p-30); }},
      {"beyond integers", [](std::mt19937_64& r) { return lattice_point(r, 1 << 25, 1); }},
      {"uneven lattice", [](std::mt19937_64& r) { return lattice_point(r, 3, 0.7); }},
      {"nudged lattice", [](std::mt19937_64& r) { return nudged(lattice_point(r, 2, 1), r); }},
      {"nudged far lattice",
       [](std::mt19937_64& r) {
         const Point3 p = lattice_point(r, 2, 1);
         return nudged(Point3{p.x + 1e5, p.y + 1e5, p.z - 1e5}, r);
       }},
      {"cospherical", sphere_point},
      {"nudged cospherical", [](std::mt19937_64& r) { return nudged(sphere_point(r), r); }},
      {"coplanar",
       [](std::mt19937_64& r) {
         const Point3 p = lattice_point(r, 50, 0.5);
         return Point3{p.x, p.y, p.x + 2 * p.y};
       }},
      {"nudged coplanar",
       [](std::mt19937_64& r) {
         const Point3 p = random_point(r);
         return nudged(Point3{p.x, p.y, p.x + 2 * p.y}, r);
       }},
      {"far away",
       [](std::mt19937_64& r) {
         const Point3 p = lattice_point(r, 3, 1e-6);
         return Point3{1e6 + p.x, -1e6 + p.y, 1e6 + p.z};
       }},
      {"many magnitudes",
       [](std::mt19937_64& r) {
         const Point3 p = random_point(r);
         const auto scaled = [&r](double v) { return std::ldexp(v, static_cast<int>(r() % 80)); };
         return Point3{scaled(p.x), scaled(p.y), scaled(p.z)};
       }},
      {"tiny", [](std::mt19937_64& r) { return lattice_point(r, 3, 0x1p-190); }},
  };
  return kFamilies;
}

}  // namespace stream_recon::families
