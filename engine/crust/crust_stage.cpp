#include "engine/crust/crust_stage.h"

#include <string>

#include "engine/windows/cloud_index.h"

namespace stream_recon {

CrustSurface build_crust(const CloudSummary& cloud, std::uint64_t point_count,
                         const CrustStageOptions& options, const StageContext& context) {
  for (const std::string& name : context.scratch.names()) {
    if (name.starts_with("crust")) context.scratch.remove(name);
  }
  CrustWindows windows;
  {
    const CloudIndex index = build_index(cloud, point_count, context);
    windows = build_crust_windows(
        index, {.threads = options.threads, .window_points = options.window_points}, context);
  }
  context.scratch.remove(kIndexPages);
  const CrustAssemblyOptions assembly{.input_points = cloud.points + cloud.far_points,
                                      .chunk_points = options.chunk_points};
  return {.facts = assemble_crust(windows, assembly, context),
          .counts = windows.counts,
          .windows = windows.windows.size(),
          .unbounded = windows.unbounded};
}

}  // namespace stream_recon
