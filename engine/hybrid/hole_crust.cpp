#include "engine/hybrid/hole_crust.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/crust/crust_sink.h"
#include "engine/each_record.h"
#include "engine/order/external_sort.h"
#include "engine/order/far_ranks.h"
#include "engine/windows/export_layout.h"

namespace stream_recon {
namespace {

constexpr std::string_view kWindowPrefix = "hole_crust_window_";

/// The faces of a window near holes, in a file that is made for the first of them.
class HoleCrustSink final : public CrustSink {
 public:
  HoleCrustSink(ScratchDirectory& scratch, std::string name, const HoleSamples& samples)
      : scratch_(scratch), name_(std::move(name)), samples_(samples) {}

  void take_vertex(const CrustVertex& vertex) override { vertices_.push_back(vertex); }

  void take_face(std::span<const CrustTriangle> triangles) override {
    holes_.clear();
    for (const CrustTriangle& triangle : triangles) {
      for (const std::uint32_t corner : triangle.corners) {
        for (const HoleSample& at : samples_.of(vertices_[corner].name.sample)) {
          holes_.push_back(at.hole);
        }
      }
    }
    std::sort(holes_.begin(), holes_.end());
    holes_.erase(std::unique(holes_.begin(), holes_.end()), holes_.end());
    for (const std::uint32_t hole : holes_) {
      for (const CrustTriangle& triangle : triangles) write(hole, triangle);
    }
  }

  void finish() override {
    if (out_) out_->finish();
  }

 private:
  void write(std::uint32_t hole, const CrustTriangle& triangle) {
    HoleCrust record{.hole = hole};
    for (std::size_t i = 0; i < 3; ++i) {
      const CrustVertex& vertex = vertices_[triangle.corners[i]];
      record.names[i] = vertex.name;
      record.points[i] = vertex.point;
      if (vertex.is_astray != 0) record.points[i].x = std::numeric_limits<double>::quiet_NaN();
    }
    const auto lowest = std::min_element(record.names.begin(), record.names.end());
    const auto turn = lowest - record.names.begin();
    std::rotate(record.names.begin(), record.names.begin() + turn, record.names.end());
    std::rotate(record.points.begin(), record.points.begin() + turn, record.points.end());
    if (!out_) out_.emplace(create_records<HoleCrust>(scratch_, name_, kHoleBlock));
    out_->append(record);
  }

  ScratchDirectory& scratch_;
  std::string name_;
  const HoleSamples& samples_;
  std::vector<CrustVertex> vertices_;
  std::vector<std::uint32_t> holes_;
  std::optional<RecordWriter<HoleCrust>> out_;
};

/// The most triangles of a hole.
std::uint64_t sort_by_hole(const StageContext& context) {
  ExternalSort<HoleCrust> sorted(
      context, {"crust of holes", std::max(context.budget.available() * 3 / 5,
                                           ExternalSort<HoleCrust>::least_memory())});
  for (const std::string& name : context.scratch.names()) {
    if (!export_first_rank(name, kWindowPrefix)) continue;
    for_each_record<HoleCrust>(context, name,
                               [&](const HoleCrust& triangle) { sorted.add(triangle); });
    context.scratch.remove(name);
  }
  auto out = create_records<HoleCrust>(context.scratch, kHoleCrust, kHoleBlock);
  std::uint64_t most = 0;
  std::uint64_t count = 0;
  std::uint32_t last = 0;
  sorted.for_each([&](const HoleCrust& triangle) {
    count = triangle.hole == last ? count + 1 : 1;
    last = triangle.hole;
    most = std::max(most, count);
    out.append(triangle);
  });
  out.finish();
  return most;
}

}  // namespace

HoleCrustResult build_hole_crust(const CloudSummary& cloud, std::uint64_t point_count,
                                 const HoleSamples& samples, const HoleCrustOptions& options,
                                 const StageContext& context) {
  HoleCrustResult result;
  {
    const CloudIndex index = build_index(cloud, point_count, context);
    const CrustWindows windows = build_crust_windows(
        index,
        {.threads = options.threads,
         .window_points = options.window_points,
         .far_ranks = far_ranks(cloud, context),
         .choice = &options.choice,
         .make_sink =
             [&](std::uint64_t first_rank) {
               return std::make_unique<HoleCrustSink>(
                   context.scratch, export_name(first_rank, kWindowPrefix), samples);
             },
         .sink_bytes_a_vertex = sizeof(CrustVertex)},
        context);
    result.power = windows.power;
  }
  context.scratch.remove(kIndexPages);
  result.most_triangles = sort_by_hole(context);
  return result;
}

}  // namespace stream_recon
