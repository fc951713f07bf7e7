#include "engine/hybrid/crust_mesh.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

#include "spatial/vector.h"

namespace stream_recon {
namespace {

constexpr std::uint32_t kUnnumbered = std::numeric_limits<std::uint32_t>::max();

}  // namespace

CrustMesh::CrustMesh(const CrustPiece& piece) {
  add_triangles(piece);
  pair_up();
  list_sides();
  near_.emplace(points_);
}

void CrustMesh::add_triangles(const CrustPiece& piece) {
  std::vector<std::uint32_t> numbers(piece.points.size(), kUnnumbered);
  const auto is_sound = [&](const std::array<std::uint32_t, 3>& t) {
    return t[0] != t[1] && t[1] != t[2] && t[2] != t[0] &&
           std::all_of(t.begin(), t.end(), [&](std::uint32_t corner) {
             return corner < piece.points.size() && is_finite(piece.points[corner]);
           });
  };
  for (const auto& corners : piece.triangles) {
    if (!is_sound(corners)) continue;
    auto& triangle = triangles_.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      std::uint32_t& number = numbers[corners[i]];
      if (number == kUnnumbered) {
        number = static_cast<std::uint32_t>(points_.size());
        points_.push_back(piece.points[corners[i]]);
      }
      triangle[i] = number;
    }
  }
}

void CrustMesh::pair_up() {
  // Into the triangle from its side, at a right angle, of unit length.
  const auto inward = [this](std::uint32_t side) {
    const Point3 along = minus(points_[to(side)], points_[from(side)]);
    const Point3 apex = minus(points_[to(next_side(side))], points_[from(side)]);
    const double square = dot(along, along);
    const Point3 across = square > 0 ? minus(apex, scaled(along, dot(apex, along) / square)) : apex;
    const double size = length(across);
    return size > 0 ? scaled(across, 1 / size) : across;
  };
  opposite_ = pair_sides(triangles_, [&](const std::array<std::uint32_t, 2>& up,
                                         const std::array<std::uint32_t, 2>& down) {
    const Point3 up0 = inward(up[0]), up1 = inward(up[1]);
    const Point3 down0 = inward(down[0]), down1 = inward(down[1]);
    return dot(up0, down1) + dot(up1, down0) < dot(up0, down0) + dot(up1, down1);
  });
}

void CrustMesh::list_sides() {
  first_.assign(points_.size() + 1, 0);
  for (std::uint32_t side = 0; side < side_count(); ++side) ++first_[from(side) + 1];
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  sides_.resize(opposite_.size());
  std::vector<std::uint32_t> place(first_.begin(), first_.end() - 1);
  for (std::uint32_t side = 0; side < side_count(); ++side) sides_[place[from(side)]++] = side;
  is_plain_.resize(opposite_.size());
  for (std::uint32_t side = 0; side < side_count(); ++side) {
    const auto same = [this](std::uint32_t start, std::uint32_t end) {
      const auto around = sides_from(start);
      return std::count_if(around.begin(), around.end(),
                           [&](std::uint32_t other) { return to(other) == end; });
    };
    is_plain_[side] = opposite_[side] != kNoSide && same(from(side), to(side)) == 1 &&
                      same(to(side), from(side)) == 1;
  }
}

Point3 CrustMesh::normal(std::uint32_t vertex) const {
  Point3 sum;
  for (const std::uint32_t side : sides_from(vertex)) {
    const Point3& at = points_[vertex];
    sum = plus(sum, cross(minus(points_[to(side)], at), minus(points_[to(next_side(side))], at)));
  }
  return sum;
}

CrustPiece CrustMesh::subdivided() const {
  CrustPiece finer;
  finer.points = points_;
  finer.triangles.reserve(4 * triangles_.size());
  std::vector<std::uint32_t> middles(opposite_.size(), kUnnumbered);
  for (std::uint32_t side = 0; side < side_count(); ++side) {
    if (middles[side] != kUnnumbered) continue;
    middles[side] = static_cast<std::uint32_t>(finer.points.size());
    if (opposite_[side] != kNoSide) middles[opposite_[side]] = middles[side];
    finer.points.push_back(scaled(plus(points_[from(side)], points_[to(side)]), 0.5));
  }
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    const auto& c = triangles_[t];
    const std::array<std::uint32_t, 3> m{middles[3 * t], middles[3 * t + 1], middles[3 * t + 2]};
    finer.triangles.push_back({c[0], m[0], m[2]});
    finer.triangles.push_back({m[0], c[1], m[1]});
    finer.triangles.push_back({m[2], m[1], c[2]});
    finer.triangles.push_back({m[0], m[1], m[2]});
  }
  return finer;
}

}  // namespace stream_recon
