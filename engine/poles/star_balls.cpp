#include "engine/poles/star_balls.h"

#include "engine/windows/final_simplices.h"
#include "spatial/circumball.h"

namespace stream_recon {

StarBalls::StarBalls(const FinalWindow& window, double scale)
    : view_(window.delaunay().view()), scale_(scale), cells_(view_.slots()) {
  find_cells(window);
  balls_.reserve(count());
  cells_.for_each([&](CellId cell) { view_.prefetch_points(cell); },
                  [&](CellId cell) {
                    balls_.push_back(ball_of({window, view_, cell}));
                  });
}

void StarBalls::find_cells(const FinalWindow& window) {
  for (CellId cell = 0; cell < view_.slots(); ++cell) {
    if (!view_.is_live(cell)) continue;
    if (!has_owned(window, view_.vertices(cell))) continue;
    if (view_.is_infinite(cell)) {
      ++infinite_count_;
    } else {
      cells_.insert(cell);
    }
  }
  cells_.number();
}

// Centres so far away that floats do not hold them are seen in their direction.
StarBalls::Ball StarBalls::ball_of(const RankedCell& cell) const {
  constexpr double kFarthest = 0x1p120;
  const Circumball ball = circumball(cell.corners(view_));
  const double radius = ball.radius() * scale_;
  Point3 centre = scaled(ball.centre, scale_);
  if (radius > kFarthest) centre = scaled(centre, kFarthest / radius);
  return {
      {static_cast<float>(centre.x), static_cast<float>(centre.y), static_cast<float>(centre.z)},
      cell.vertices[0]};
}

}  // namespace stream_recon
