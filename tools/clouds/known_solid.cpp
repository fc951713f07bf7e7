#include "tools/clouds/known_solid.h"

#include <array>
#include <stdexcept>

#include "spatial/vector.h"
#include "tools/clouds/round_solids.h"
#include "tools/clouds/rounded_folds.h"
#include "tools/clouds/wavy_solids.h"

namespace stream_recon {
namespace {

constexpr std::array<std::string_view, 10> kNames{"sphere", "blob",   "torus", "folded", "sponge",
                                                  "folds",  "nested", "pair",  "plate",  "uneven"};
constexpr double kDefaultWidth = 0.05;
constexpr Point3 kOblique{2.0 / 7, 3.0 / 7, 6.0 / 7};

double checked_width(double width) {
  if (width == 0) return kDefaultWidth;
  if (width > 0 && width < 1) return width;
  throw std::invalid_argument("the width must be above 0 and below 1");
}

std::unique_ptr<const KnownSolid> make_pair_of_balls(double gap) {
  constexpr double kRadius = 0.5;
  const Point3 center = scaled(kOblique, kRadius + gap / 2);
  return std::make_unique<SphereSolid>(std::vector<SphereSolid::Sphere>{
      {center, kRadius, false}, {scaled(center, -1), kRadius, false}});
}

/// A shell with a ball in its cavity.
std::unique_ptr<const KnownSolid> make_nested_balls() {
  return std::make_unique<SphereSolid>(std::vector<SphereSolid::Sphere>{
      {{0, 0, 0}, 1, false}, {{0, 0, 0}, 0.7, true}, {{0, 0, 0}, 0.4, false}});
}

}  // namespace

std::span<const std::string_view> solid_names() {
  return kNames;
}

std::unique_ptr<const KnownSolid> make_solid(const SolidOptions& options) {
  const double width = checked_width(options.width);
  if (options.name == "sphere")
    return std::make_unique<SphereSolid>(std::vector<SphereSolid::Sphere>{{{0, 0, 0}, 1, false}});
  if (options.name == "blob") return std::make_unique<BlobSolid>();
  if (options.name == "torus") return std::make_unique<TorusSolid>(true);
  if (options.name == "folded") return std::make_unique<FoldedSolid>(1);
  if (options.name == "sponge") return std::make_unique<FoldedSolid>(FoldedSolid::kSpongeRadius);
  if (options.name == "folds") return std::make_unique<RoundedFolds>();
  if (options.name == "nested") return make_nested_balls();
  if (options.name == "pair") return make_pair_of_balls(width);
  if (options.name == "plate") return std::make_unique<PlateSolid>(width);
  if (options.name == "uneven") return std::make_unique<TorusSolid>(false);
  throw std::invalid_argument("not a known solid: " + options.name);
}

}  // namespace stream_recon
