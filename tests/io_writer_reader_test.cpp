// Our readers get out of our writers' files what the chunks hold, bit for bit.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "io/point_source.h"
#include "io/pvtp_index.h"
#include "io/scratch_directory.h"
#include "io/vtp_mesh_reader.h"
#include "tests/io_test_folder.h"
#include "tests/io_writer_surface.h"

namespace stream_recon {
namespace {

class ReadBack : public testing::TestWithParam<Scalar> {
 protected:
  std::string write(const std::string& name) {
    write_surface(surface_, {folder_ / name, GetParam(), &scratch_, true});
    return folder_ / name;
  }

  TestFolder folder_;
  ScratchDirectory scratch_{{folder_.path()}};
  const std::vector<SurfaceChunk> surface_ = make_surface(3, 30000, GetParam(), 1);
};

TEST_P(ReadBack, ChunksAreTheChunksThatWereWritten) {
  const auto pieces = read_pvtp_index(write("a & b.pvtp"));
  ASSERT_EQ(pieces.size(), surface_.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    SCOPED_TRACE(pieces[i]);
    const VtpMesh mesh = read_vtp_mesh(pieces[i]);
    const SurfaceChunk& chunk = surface_[i];
    EXPECT_TRUE(mesh.points == chunk.points);
    EXPECT_TRUE(mesh.triangles == chunk.triangles);
    EXPECT_TRUE(mesh.delta == chunk.delta);
    EXPECT_TRUE(mesh.closure == chunk.closure);
    EXPECT_TRUE(mesh.global_ids == chunk.global_ids);
    ASSERT_EQ(mesh.source.size(), chunk.source.size());
    for (std::size_t t = 0; t < mesh.source.size(); ++t) {
      ASSERT_EQ(mesh.source[t], static_cast<std::uint8_t>(chunk.source[t]));
    }
  }
}

TEST_P(ReadBack, SingleFilesHoldEachVertexOnceInItsOrder) {
  std::vector<Point3> vertices;
  for (const SurfaceChunk& chunk : surface_) {
    for (std::size_t i = 0; i < chunk.points.size(); ++i) {
      if (chunk.vertex_numbers[i] == vertices.size()) vertices.push_back(chunk.points[i]);
    }
  }
  for (const char* name : {"a.ply", "a.vtk"}) {
    SCOPED_TRACE(name);
    const auto source = open_point_source(write(name), InputFormat::kAuto);
    std::vector<Point3> read(vertices.size() + 1);
    std::size_t count = 0;
    while (const std::size_t got = source->read(std::span(read).subspan(count))) count += got;
    ASSERT_EQ(count, vertices.size());
    read.resize(count);
    EXPECT_TRUE(read == vertices);
  }
}

INSTANTIATE_TEST_SUITE_P(Scalars, ReadBack, testing::Values(Scalar::kFloat32, Scalar::kFloat64),
                         [](const auto& scalar) {
                           return scalar.param == Scalar::kFloat32 ? "Float32" : "Float64";
                         });

}  // namespace
}  // namespace stream_recon
