#include "engine/crust/crust_stage.h"

#include <string>

#include "engine/order/far_ranks.h"
#include "engine/shape/shape_store.h"
#include "engine/windows/cloud_index.h"

namespace stream_recon {
CrustSurface build_crust(const CloudSummary& cloud, std::uint64_t point_count,
                         const CrustStageOptions& options, const StageContext& context) {
  for (const std::string& name : context.scratch.names()) {
    if (name.starts_with("crust") || name.starts_with(kShapePrefix)) context.scratch.remove(name);
  }
  CrustWindows windows;
  {
    const CloudIndex index = build_index(cloud, point_count, context);
    windows = build_crust_windows(index,
                                  {.threads = options.threads,
                                   .window_points = options.window_points,
                                   .far_ranks = far_ranks(cloud, context),
                                   .has_crust = options.has_crust,
                                   .has_shape = options.has_shape},
                                  context);
  }
  context.scratch.remove(kIndexPages);
  if (options.has_shape) store_shape(windows.shape_windows, context);
  const CrustAssemblyOptions assembly{.input_points = cloud.points + cloud.far_points,
                                      .chunk_points = options.chunk_points};
  return {.facts = options.has_crust ? assemble_crust(windows, assembly, context) : CrustFacts{},
          .power = windows.power,
          .shape = windows.shape};
}

}  // namespace stream_recon
