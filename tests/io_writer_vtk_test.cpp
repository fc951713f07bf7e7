// VTK's own readers get out of our files what the chunks hold, bit for bit.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "io/scratch_directory.h"
#include "tests/io_test_folder.h"
#include "tests/io_writer_surface.h"

namespace stream_recon {
namespace {

/// The arrays of a surface as VTK holds them.
struct Arrays {
  std::string points;
  std::string triangles;
  std::string point_ids;
  std::string delta;
  std::string source;
  std::string closure;
};

template <class Number>
void put(std::string& bytes, Number value) {
  char raw[sizeof value];  // NOLINT(modernize-avoid-c-arrays)
  std::memcpy(raw, &value, sizeof value);
  bytes.append(raw, sizeof value);
}

void put_point(std::string& bytes, const Point3& p, Scalar scalar) {
  for (const double value : {p.x, p.y, p.z}) {
    if (scalar == Scalar::kFloat32) {
      put(bytes, static_cast<float>(value));
    } else {
      put(bytes, value);
    }
  }
}

/// Chunk after chunk, points repeated (.pvtp), or each vertex once.
Arrays expected_arrays(const std::vector<SurfaceChunk>& surface, Scalar scalar, bool is_merged) {
  Arrays arrays;
  std::uint64_t points = 0;
  for (const SurfaceChunk& chunk : surface) {
    const std::uint64_t first = points;
    for (std::size_t i = 0; i < chunk.points.size(); ++i) {
      if (is_merged && chunk.vertex_numbers[i] < points) continue;
      put_point(arrays.points, chunk.points[i], scalar);
      put(arrays.point_ids, chunk.global_ids[i]);
      ++points;
    }
    for (const auto& triangle : chunk.triangles) {
      for (const std::uint32_t corner : triangle) {
        put(arrays.triangles, is_merged ? chunk.vertex_numbers[corner] : first + corner);
      }
    }
    for (const float angle : chunk.delta) put(arrays.delta, angle);
    for (const float closure : chunk.closure) put(arrays.closure, closure);
    for (const TriangleSource source : chunk.source) put(arrays.source, source);
  }
  return arrays;
}

struct Case {
  const char* name;
  Scalar scalar;
  std::size_t chunks;
  std::size_t triangles;
  bool has_closure = true;
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.name << ", " << (c.scalar == Scalar::kFloat32 ? "float32, " : "float64, ") << c.chunks
       << " chunks of " << c.triangles << " triangles";
}

class VtkReads : public testing::TestWithParam<Case> {};

TEST_P(VtkReads, TheSameBitsThatWereWritten) {
  const Case& c = GetParam();
  const TestFolder folder;
  ScratchDirectory scratch({folder.path()});
  const auto surface = make_surface(c.chunks, c.triangles, c.scalar, 1);
  write_surface(surface, {folder / c.name, c.scalar, &scratch, c.has_closure});

  const std::string log = folder / "log";
  const std::string command = std::string(STREAM_RECON_VTK_PYTHON " " STREAM_RECON_TESTS) +
                              "/io_writer_vtk_dump.py '" + folder / c.name + "' " + folder.path() +
                              " > " + log + " 2>&1";
  const int status = std::system(command.c_str());  // NOLINT(concurrency-mt-unsafe,cert-env33-c)
  // 77 is the script's word for a missing VTK, 127 the shell's for a missing Python.
  if (WEXITSTATUS(status) == 77 || WEXITSTATUS(status) == 127) {
    GTEST_SKIP() << file_bytes(log) << ": install python3-vtk9";
  }
  ASSERT_EQ(status, 0) << file_bytes(log);

  const std::string name = c.name;
  const Arrays arrays = expected_arrays(surface, c.scalar, !name.ends_with(".pvtp"));
  EXPECT_TRUE(file_bytes(folder / "points") == arrays.points) << file_bytes(log);
  EXPECT_TRUE(file_bytes(folder / "triangles") == arrays.triangles) << file_bytes(log);
  if (name.ends_with(".ply")) return;
  EXPECT_TRUE(file_bytes(folder / "point_ids") == arrays.point_ids) << file_bytes(log);
  EXPECT_TRUE(file_bytes(folder / "delta") == arrays.delta) << file_bytes(log);
  EXPECT_TRUE(file_bytes(folder / "source") == arrays.source) << file_bytes(log);
  EXPECT_TRUE(file_bytes(folder / "closure") == (c.has_closure ? arrays.closure : ""))
      << file_bytes(log);
}

// 70,000 triangles make arrays of more than one compressed block.
INSTANTIATE_TEST_SUITE_P(Surfaces, VtkReads,
                         testing::Values(Case{"a.pvtp", Scalar::kFloat64, 3, 1000},
                                         Case{"a.pvtp", Scalar::kFloat32, 3, 1000, false},
                                         Case{"a.pvtp", Scalar::kFloat64, 2, 70000},
                                         Case{"a <b> & c.pvtp", Scalar::kFloat64, 2, 10},
                                         Case{"a.pvtp", Scalar::kFloat64, 0, 0},
                                         Case{"a.pvtp", Scalar::kFloat64, 1, 0},
                                         Case{"a.vtk", Scalar::kFloat64, 3, 1000},
                                         Case{"a.vtk", Scalar::kFloat32, 3, 1000, false},
                                         Case{"a.vtk", Scalar::kFloat64, 0, 0},
                                         Case{"a.ply", Scalar::kFloat32, 3, 1000},
                                         Case{"a.ply", Scalar::kFloat32, 0, 0}));

}  // namespace
}  // namespace stream_recon
