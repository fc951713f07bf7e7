#include "tools/sampling/conversion.h"

#include <fmt/format.h>

#include <filesystem>

#include "tools/sampling/each_label.h"

namespace stream_recon {
namespace {

class LabelFile : public LabelSink {
 public:
  LabelFile(const PointSinkOptions& options, double label, LabelCounts& total)
      : sink_(options), label_(label), total_(total) {}

  void take(const Point3& point) override { sink_.write({&point, 1}); }
  void finish(const SampleCounts& counts) override {
    total_.points += counts.points;
    if (counts.points == 0) {
      total_.smoothed_away.push_back(label_);
    } else {
      sink_.finish();
    }
  }

 private:
  PointSink sink_;
  double label_;
  LabelCounts& total_;
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
    return std::make_unique<LabelFile>(file, label, counts);
  });
  return counts;
}

}  // namespace stream_recon
