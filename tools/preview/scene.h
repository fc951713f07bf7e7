// The inputs of a picture, and what must be known of them before they are drawn.
//
// Memory: see preview.h. Thread rule: one thread.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "spatial/box.h"
#include "tools/preview/components.h"
#include "tools/preview/legend.h"
#include "tools/preview/mesh_parts.h"
#include "tools/preview/preview.h"

namespace stream_recon {

class Scene {
 public:
  /// Opens all inputs and looks through them. \throw as draw_preview()
  Scene(const std::vector<PreviewInput>& inputs, const std::vector<NamedView>& views);

  struct Piece {
    PreviewInput input;
    std::unique_ptr<MeshParts> parts;
    std::uint64_t triangles = 0;
    std::uint64_t loose_points = 0;   ///< in parts without triangles
    std::uint64_t point_numbers = 0;  ///< one more than the highest
    double greatest_delta = 0;
    std::set<std::uint8_t> sources;
    std::optional<Components> components;
  };

  const std::vector<Piece>& pieces() const { return pieces_; }
  /// Of all that is drawn, in the coordinates of a view.
  const Box3& box(std::size_t view) const { return boxes_[view]; }

  /// The paint of a triangle of a part of piece `piece`.
  Paint paint(std::size_t piece, const VtpMesh& part, std::size_t triangle);
  /// The paint of a point without triangles.
  Paint point_paint(std::size_t piece) const;
  std::vector<Color> palette() const;
  /// What the colours mean, as far as they mean something.
  std::vector<LegendBlock> legend() const;

 private:
  void look_through(Piece& piece, const std::vector<NamedView>& views);
  void find_components(Piece& piece);
  double scale_end() const;

  std::vector<Piece> pieces_;
  std::vector<Box3> boxes_;
};

}  // namespace stream_recon
