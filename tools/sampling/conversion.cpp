#include "tools/sampling/conversion.h"

#include <fmt/format.h>

#include <filesystem>

#include "tools/sampling/each_label.h"

namespace stream_recon {
namespace {

class LabelFile : public LabelSink {
 public:
  LabelFile(const PointSinkOptions& options, std::uint64_t& total)
      : sink_(options), total_(total) {}

  void take(const Point3& point) override { sink_.write({&point, 1}); }
  void finish(const SampleCounts& counts) override {
    sink_.finish();
    total_ += counts.points;
  }

 private:
  PointSink sink_;
  std::uint64_t& total_;
};

}  // namespace

SampleCounts write_points(Volume& volume, const SamplingOptions& options, PointSinkOptions output) {
  Sampling sampling(volume, options);
  output.metadata = sampling.metadata(volume.source());
  output.count.reset();
  if (output.format == PointFormat::kPly && output.path == "-") {
    output.count = sampling.run([](const Point3&) {}).points;
  }
  PointSink sink(output);
  const SampleCounts counts = sampling.run([&](const Point3& p) { sink.write({&p, 1}); });
  sink.finish();
  return counts;
}

std::string label_path(const std::string& path, double label) {
  const std::filesystem::path file(path);
  const std::string name = fmt::format("{}_{}", file.stem().string(), label);
  return (file.parent_path() / (name + file.extension().string())).string();
}

LabelCounts write_each_label(Volume& volume, const SamplingOptions& options,
                             const PointSinkOptions& output) {
  LabelCounts counts;
  counts.labels = sample_each_label(volume, options, [&](double label) {
    SamplingOptions one = options;
    one.selection = VoxelSelection::of_labels({label});
    PointSinkOptions file = output;
    file.path = label_path(output.path, label);
    file.metadata = Sampling(volume, one).metadata(volume.source());
    return std::make_unique<LabelFile>(file, counts.points);
  });
  return counts;
}

}  // namespace stream_recon
