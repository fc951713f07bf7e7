// A walk through the tetrahedra of a window of samples, from neighbour to neighbour, which asks of
// each whether a sphere is in conflict with it.
//
// Guarantees: answers as may_conflict() gives them, but that it may say no where only the slack of
// that function says yes. Balls that were asked for lately are kept as floats with a bound on their
// rounding; where that does not decide, may_conflict() does. Thread rule: one window's. Memory:
// bytes(): 200 bytes an owned sample, and 4 a tetrahedron of the window. Cost: 10 ns a test where
// the ball is kept, 100 ns otherwise. Source: docs/algorithms/weighted.md
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "engine/windows/certified_window.h"
#include "spatial/cell_view.h"
#include "spatial/orthosphere.h"

namespace stream_recon {

class BallWalk {
 public:
  /// \pre The window has been built, and outlives the object.
  explicit BallWalk(const CertifiedWindow& samples);

  /// Begins anew. \pre The window's structure does not change before the last step.
  void begin();
  /// Whether this walk comes by for the first time.
  bool visit(CellId cell) { return std::exchange(stamps_[cell], number_) != number_; }
  /// \pre Visited. Its neighbours are looked at by the next step.
  void add(CellId cell);
  /// Those beside what was added since the last step, with repetitions; empty at the end.
  const std::vector<CellId>& step();

  /// The sphere of in_conflict().
  void aim(const Orthosphere& sphere) { sphere_ = sphere; }
  enum class Kind : std::uint8_t { kNotFinal, kInfinite, kBounded };
  Kind kind(CellId cell) const {
    return ball_at(cell).cell == cell ? Kind::kBounded : kind_of_unknown(cell);
  }
  /// \pre aim() was called for this walk, and the cell's kind is kBounded
  bool in_conflict(CellId cell);

  /// The cell is asked about soon.
  void prefetch(CellId cell) const { __builtin_prefetch(&ball_at(cell)); }

  std::uint64_t bytes() const;

 private:
  static constexpr CellId kNoCell = static_cast<CellId>(-1);

  struct Ball {
    CellId cell = kNoCell;
    VertexId corner = 0;        ///< of it
    float x = 0, y = 0, z = 0;  ///< the centre, relative to the corner
    float error = 0;            ///< of the power of a point at length 1 from the corner
  };

  Kind kind_of_unknown(CellId cell) const;
  const Ball& ball_at(CellId cell) const { return balls_[cell & (balls_.size() - 1)]; }
  Ball ball_of(CellId cell) const;

  const CertifiedWindow& samples_;
  CellView cells_{CellView::Parts{}};
  std::vector<Ball> balls_;  ///< of a power of two, each where the low bits of its cell say
  std::vector<std::uint32_t> stamps_;  ///< of cells: the last walk that came by
  std::uint32_t number_ = 0;           ///< of the walk
  std::size_t looked_at_ = 0;
  std::vector<CellId> walk_;
  std::vector<CellId> neighbors_;
  Orthosphere sphere_;
};

}  // namespace stream_recon
