// What a window hands on of its samples' poles.
//
// Guarantees: each pole of the window once, as a name and a ball, in two lists of one order under
// the window's first rank as chunk; balls are functions of the four samples alone. They are
// computed here, where the samples are in memory: a tetrahedron's samples lie on both sides of the
// body, far apart in the order of the store. Thread rule: one thread. Memory: pole_export_memory().
// Cost: 1 us a pole.
#pragma once

#include <cstdint>
#include <functional>

#include "engine/labels/attachment.h"
#include "engine/poles/star_poles.h"
#include "engine/windows/export_writer.h"
#include "engine/windows/final_window.h"

namespace stream_recon {

/// What else is told of the ball of a finite cell.
struct PoleTraits {
  std::function<Attachment(CellId)> attachment;      ///< how its label will be found
  std::function<bool(CellId, double)> is_too_small;  ///< by its radius, units of the input
};

/// \pre The poles are those of the window. \throw IoError
void export_poles(const FinalWindow& window, const StarPoles& poles, const PoleTraits& traits,
                  ExportWriter& out);

/// Bytes, for so many owned points.
constexpr std::uint64_t pole_export_memory(std::uint64_t owned) {
  return 2 * owned * sizeof(CellId);
}

}  // namespace stream_recon
