// mesh-check counts what a plain count in core finds, whatever the format, memory and threads.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "engine/process_memory.h"
#include "io/error.h"
#include "tests/mesh_files.h"
#include "tests/mesh_oracle.h"
#include "tools/check/facts_text.h"
#include "tools/check/mesh_check.h"
#include "tools/check/requirements.h"
#include "tools/check/triangle_shape.h"

namespace stream_recon {
namespace {

constexpr std::uint64_t kMebi = std::uint64_t{1} << 20;

/// All numbers but area, volume and box.
void expect_equal_counts(const MeshFacts& a, const MeshFacts& b) {
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.repeated_corner_triangles, b.repeated_corner_triangles);
  EXPECT_EQ(a.zero_area_triangles, b.zero_area_triangles);
  EXPECT_EQ(a.duplicate_triangles, b.duplicate_triangles);
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(a.unused_vertices, b.unused_vertices);
  EXPECT_EQ(a.nonmanifold_vertices, b.nonmanifold_vertices);
  EXPECT_EQ(a.contradictory_ids, b.contradictory_ids);
  EXPECT_EQ(a.edges, b.edges);
  EXPECT_EQ(a.boundary_edges, b.boundary_edges);
  EXPECT_EQ(a.nonmanifold_edges, b.nonmanifold_edges);
  EXPECT_EQ(a.wrongly_oriented_edges, b.wrongly_oriented_edges);
  EXPECT_EQ(a.boundary_rings, b.boundary_rings);
  EXPECT_EQ(a.simple_boundary_rings, b.simple_boundary_rings);
  EXPECT_EQ(a.components, b.components);
  EXPECT_EQ(a.closed_components, b.closed_components);
  EXPECT_EQ(a.manifold_components, b.manifold_components);
  EXPECT_EQ(a.oriented_components, b.oriented_components);
  EXPECT_EQ(a.largest_component_triangles, b.largest_component_triangles);
  EXPECT_EQ(a.components_by_genus, b.components_by_genus);
}

class MeshCheck : public testing::Test {
 protected:
  MeshFacts check(const std::string& path, std::uint64_t memory = 64 * kMebi,
                  unsigned threads = 2) const {
    return check_mesh(
        {.path = path, .memory_bytes = memory, .threads = threads, .scratch = folder_.path()});
  }

  /// The facts of a mesh, equal in all formats and to the oracle's.
  MeshFacts facts_of(const TestMesh& mesh) const {
    put_bytes(folder_ / "mesh.ply", ascii_ply(mesh));
    const MeshFacts facts = check(folder_ / "mesh.ply");
    expect_equal_counts(facts, MeshOracle(mesh).facts());
    write_chunked(mesh, folder_ / "mesh.pvtp", 3);
    write_single(mesh, folder_, folder_ / "single.ply");
    write_single(mesh, folder_, folder_ / "single.vtk");
    for (const char* name : {"mesh.pvtp", "single.ply", "single.vtk"}) {
      SCOPED_TRACE(name);
      MeshFacts other = check(folder_ / name);
      // What no triangle uses is not in these files; corners of none but degenerate ones are.
      other.unused_vertices = facts.unused_vertices;
      expect_equal_counts(other, facts);
      EXPECT_EQ(other.area, facts.area);
      EXPECT_EQ(other.volume, facts.volume);
    }
    return facts;
  }

  TestFolder folder_;
};

TestMesh tetrahedron() {
  return {{{0, 0, 0}, {6, 0, 0}, {0, 6, 0}, {0, 0, 6}},
          {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
}

/// Puts a second mesh beside the first; `shared` of its first vertices are the first mesh's.
TestMesh joined(TestMesh a, const TestMesh& b, std::uint32_t shared) {
  const auto base = static_cast<std::uint32_t>(a.points.size());
  for (std::size_t i = shared; i < b.points.size(); ++i) {
    a.points.push_back({-b.points[i].x, -b.points[i].y, -b.points[i].z});
  }
  for (auto triangle : b.triangles) {
    for (auto& corner : triangle) {
      if (corner >= shared) corner = base + corner - shared;
    }
    a.triangles.push_back(triangle);
  }
  return a;
}

TestMesh cube() {
  TestMesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.points.push_back({double(i & 1), double(i >> 1 & 1), double(i >> 2 & 1)});
  }
  for (const auto& [a, b, c, d] : std::initializer_list<std::array<std::uint32_t, 4>>{
           {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  }
  return mesh;
}

/// columns x rows quads that close to a torus; a strip where rows do not close.
TestMesh torus(int columns, int rows) {
  TestMesh mesh;
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < rows; ++j) {
      const double u = 2 * std::numbers::pi * i / columns, v = 2 * std::numbers::pi * j / rows;
      mesh.points.push_back({std::round(1000 * (3 + std::cos(v)) * std::cos(u)),
                             std::round(1000 * (3 + std::cos(v)) * std::sin(u)),
                             std::round(1000 * std::sin(v))});
    }
  const auto at = [=](int i, int j) {
    return static_cast<std::uint32_t>(i % columns * rows + j % rows);
  };
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < rows; ++j) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
      mesh.triangles.push_back({at(i, j + 1), at(i + 1, j), at(i + 1, j + 1)});
    }
  return mesh;
}

TEST_F(MeshCheck, ATetrahedronIsASphere) {
  const MeshFacts facts = facts_of(tetrahedron());
  EXPECT_TRUE(facts.is_closed() && facts.is_manifold() && facts.is_oriented());
  EXPECT_EQ(facts.euler(), 2);
  EXPECT_EQ(facts.genus(), 0);
  EXPECT_DOUBLE_EQ(facts.volume.value(), 36);
  EXPECT_DOUBLE_EQ(facts.area, 3 * 18 + 36 * std::sqrt(3) / 2);
}

TEST_F(MeshCheck, ACubeHasItsAreaVolumeAndBox) {
  const MeshFacts facts = facts_of(cube());
  EXPECT_EQ(facts.area, 6);
  EXPECT_DOUBLE_EQ(facts.volume.value(), 1);
  EXPECT_EQ(facts.box.low, (Point3{0, 0, 0}));
  EXPECT_EQ(facts.box.high, (Point3{1, 1, 1}));
  EXPECT_EQ(facts.genus(), 0);
}

TEST_F(MeshCheck, ATorusHasOneHandle) {
  const MeshFacts facts = facts_of(torus(12, 7));
  EXPECT_EQ(facts.euler(), 0);
  EXPECT_EQ(facts.genus(), 1);
  EXPECT_EQ(facts.components_by_genus, (std::map<std::int64_t, std::uint64_t>{{1, 1}}));
}

TEST_F(MeshCheck, BodiesThatShareAVertexAreNotManifoldThere) {
  const MeshFacts facts = facts_of(joined(tetrahedron(), tetrahedron(), 1));
  EXPECT_EQ(facts.components, 1U);
  EXPECT_EQ(facts.nonmanifold_vertices, 1U);
  EXPECT_EQ(facts.nonmanifold_edges, 0U);
  EXPECT_TRUE(facts.is_closed() && facts.is_oriented() && !facts.is_manifold());
  EXPECT_EQ(facts.genus(), std::nullopt);
  EXPECT_TRUE(facts.volume.has_value());
}

TEST_F(MeshCheck, BodiesThatShareAnEdgeAreNotManifoldAlongIt) {
  const MeshFacts facts = facts_of(joined(tetrahedron(), tetrahedron(), 2));
  EXPECT_EQ(facts.nonmanifold_edges, 1U);
  EXPECT_EQ(facts.nonmanifold_vertices, 2U);
  EXPECT_EQ(facts.boundary_edges, 0U);
}

TEST_F(MeshCheck, BodiesApartAreComponents) {
  const MeshFacts facts = facts_of(joined(joined(tetrahedron(), torus(9, 5), 0), cube(), 0));
  EXPECT_EQ(facts.components, 3U);
  EXPECT_EQ(facts.closed_components, 3U);
  EXPECT_EQ(facts.genus(), 1);
  EXPECT_EQ(facts.components_by_genus, (std::map<std::int64_t, std::uint64_t>{{0, 2}, {1, 1}}));
  EXPECT_EQ(facts.largest_component_triangles, 90U);
}

TEST_F(MeshCheck, AMoebiusStripCannotBeOriented) {
  TestMesh mesh;
  constexpr std::uint32_t kSteps = 9;
  for (std::uint32_t i = 0; i < kSteps; ++i) {
    mesh.points.push_back({double(i), 0, double(i * i)});
    mesh.points.push_back({double(i), 1, double(i * i)});
  }
  for (std::uint32_t i = 0; i < kSteps; ++i) {
    const std::uint32_t a = 2 * i, b = 2 * i + 1;
    const std::uint32_t c = i + 1 < kSteps ? a + 2 : 1, d = i + 1 < kSteps ? b + 2 : 0;
    mesh.triangles.push_back({a, c, b});
    mesh.triangles.push_back({b, c, d});
  }
  const MeshFacts facts = facts_of(mesh);
  EXPECT_EQ(facts.wrongly_oriented_edges, 1U);
  EXPECT_TRUE(facts.is_manifold() && !facts.is_oriented() && !facts.is_closed());
  EXPECT_EQ(facts.boundary_rings, 1U);
  EXPECT_EQ(facts.simple_boundary_rings, 1U);
  EXPECT_EQ(facts.euler(), 0);
  EXPECT_EQ(facts.volume, std::nullopt);
}

TEST_F(MeshCheck, AnOpenSquareHasOneRing) {
  const MeshFacts facts =
      facts_of({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}});
  EXPECT_EQ(facts.boundary_edges, 4U);
  EXPECT_EQ(facts.boundary_rings, 1U);
  EXPECT_EQ(facts.simple_boundary_rings, 1U);
  EXPECT_EQ(facts.euler(), 1);
  EXPECT_EQ(facts.genus(), std::nullopt);
  EXPECT_EQ(facts.area, 1);
}

TEST_F(MeshCheck, RingsThatTouchAreOneRingThatIsNotSimple) {
  const MeshFacts facts = facts_of(
      {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}, {5, 0, 0}, {6, 0, 0}, {6, 1, 0}},
       {{0, 1, 2}, {0, 3, 4}, {5, 6, 7}}});
  EXPECT_EQ(facts.boundary_rings, 2U);
  EXPECT_EQ(facts.simple_boundary_rings, 1U);
}

TEST_F(MeshCheck, AHubOfThousandsOfTrianglesIsOneFan) {
  TestMesh mesh{{{0, 0, 0}}, {}};
  constexpr std::uint32_t kSpokes = 3000;
  for (std::uint32_t i = 1; i <= kSpokes; ++i) {
    mesh.points.push_back({double(i), double(i) * i, 1});
    mesh.triangles.push_back({0, i, i % kSpokes + 1});
  }
  const MeshFacts facts = facts_of(mesh);
  EXPECT_TRUE(facts.is_manifold());
  EXPECT_EQ(facts.boundary_edges, kSpokes);
  EXPECT_EQ(facts.simple_boundary_rings, 1U);
}

TEST_F(MeshCheck, WhatIsDoubleOrFlatIsCounted) {
  const MeshFacts facts = facts_of({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {9, 9, 9}},
                                    {{0, 1, 2}, {2, 1, 0}, {1, 2, 0}, {0, 1, 3}, {1, 1, 2}}});
  EXPECT_EQ(facts.triangles, 5U);
  EXPECT_EQ(facts.duplicate_triangles, 2U);
  EXPECT_EQ(facts.zero_area_triangles, 2U);
  EXPECT_EQ(facts.repeated_corner_triangles, 1U);
  EXPECT_EQ(facts.unused_vertices, 1U);
}

/// Random triangles among few vertices: every defect at once.
TestMesh soup(unsigned seed, std::uint32_t vertices, std::size_t triangles) {
  std::mt19937 random(seed);
  TestMesh mesh;
  const auto coordinate = [&] { return double(random() % 5); };
  for (std::uint32_t i = 0; i < vertices; ++i) {
    mesh.points.push_back({coordinate(), coordinate(), coordinate()});
  }
  for (std::size_t i = 0; i < triangles; ++i) {
    const std::uint32_t first = random() % vertices;
    const auto near = [&] { return static_cast<std::uint32_t>((first + random() % 7) % vertices); };
    mesh.triangles.push_back({first, near(), near()});
  }
  return mesh;
}

TEST_F(MeshCheck, RandomSoupsAreCountedAsInCore) {
  for (unsigned seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE(seed);
    facts_of(soup(seed, 10 + seed * 15, 40 + seed * 10));
  }
}

/// Thousands of soups and tori, several batches and runs long.
TEST_F(MeshCheck, MemoryAndThreadsChangeNothing) {
  TestMesh mesh = soup(5, 30000, 60000);
  mesh = joined(std::move(mesh), torus(300, 100), 0);
  for (unsigned i = 0; i < 200; ++i) mesh = joined(std::move(mesh), torus(5, 4), 0);
  write_chunked(mesh, folder_ / "mesh.pvtp", 7000);
  const std::string known = facts_json(check(folder_ / "mesh.pvtp", 512 * kMebi, 1));
  MeshFacts expected = MeshOracle(mesh).facts();
  const MeshFacts facts = check(folder_ / "mesh.pvtp");
  expected.unused_vertices = facts.unused_vertices;  // the writer leaves most of them out
  expect_equal_counts(facts, expected);
  for (const std::uint64_t memory : {44 * kMebi, 50 * kMebi, 300 * kMebi}) {
    for (const unsigned threads : {1U, 3U}) {
      EXPECT_EQ(facts_json(check(folder_ / "mesh.pvtp", memory, threads)), known)
          << memory << ' ' << threads;
    }
  }
  write_single(mesh, folder_, folder_ / "mesh.ply");
  EXPECT_EQ(facts_json(check(folder_ / "mesh.ply", 44 * kMebi)), known);
}

TEST_F(MeshCheck, TooLittleMemoryIsRefusedWithWhatWouldDo) {
  write_chunked(torus(300, 200), folder_ / "mesh.pvtp", 1000000);
  try {
    check(folder_ / "mesh.pvtp", 20 * kMebi);
    FAIL() << "20 MiB should not do";
  } catch (const BudgetError& e) {
    EXPECT_NE(std::string(e.what()).find("or more"), std::string::npos) << e.what();
  }
}

TEST_F(MeshCheck, CopiesWithOtherCoordinatesAreReported) {
  TestMesh mesh = tetrahedron();
  std::vector<SurfaceChunk> chunks = chunks_of(mesh, 1);
  for (Point3& point : chunks[2].points) point.x += 1e-9;
  const auto writer = make_surface_writer({.path = folder_ / "mesh.pvtp"});
  for (std::size_t i = 0; i < chunks.size(); ++i) writer->write(i, chunks[i]);
  writer->finish();
  const MeshFacts facts = check(folder_ / "mesh.pvtp");
  EXPECT_EQ(facts.contradictory_ids, 3U);
  EXPECT_EQ(facts.vertices, 4U);
  EXPECT_EQ(unmet_requirements(facts, {"closed", "consistent-ids"}),
            "ids are not consistent: 3 ids whose points differ between chunks");
}

TEST_F(MeshCheck, AnEmptyMeshHasNothingWrong) {
  make_surface_writer({.path = folder_ / "none.pvtp"})->finish();
  const MeshFacts facts = check(folder_ / "none.pvtp");
  EXPECT_EQ(facts.triangles, 0U);
  EXPECT_EQ(unmet_requirements(facts, {"closed", "manifold", "oriented"}), "");
  EXPECT_EQ(unmet_requirements(facts, {"one-component"}), "not one component: 0 components");
  EXPECT_NE(facts_json(facts).find("\"low\": null"), std::string::npos);
}

TEST_F(MeshCheck, WhatIsNoMeshIsRefused) {
  const std::string whole = ascii_ply(tetrahedron());
  for (std::size_t size = whole.find("end_header"); size + 1 < whole.size(); size += 7) {
    put_bytes(folder_ / "cut.ply", whole.substr(0, size));
    EXPECT_THROW(check(folder_ / "cut.ply"), InputError) << size;
  }
  write_single(tetrahedron(), folder_, folder_ / "whole.ply");
  write_single(tetrahedron(), folder_, folder_ / "whole.vtk");
  const std::string ply = file_bytes(folder_ / "whole.ply");
  put_bytes(folder_ / "cut.ply", ply.substr(0, ply.size() - 1));
  EXPECT_THROW(check(folder_ / "cut.ply"), InputError);
  put_bytes(folder_ / "long.ply", ply + "x");
  EXPECT_THROW(check(folder_ / "long.ply"), InputError);
  const std::string vtk = file_bytes(folder_ / "whole.vtk");
  put_bytes(folder_ / "cut.vtk", vtk.substr(0, vtk.find("CELL_DATA") - 5));
  EXPECT_THROW(check(folder_ / "cut.vtk"), InputError);

  std::string far = whole;
  far.replace(far.rfind("3 0 3 2"), 7, "3 0 9 2");
  put_bytes(folder_ / "far.ply", far);
  EXPECT_THROW(check(folder_ / "far.ply"), InputError);
  put_bytes(folder_ / "nan.ply",
            ascii_ply({{{0, 0, 0}, {1, 0, std::nan("")}, {0, 1, 0}}, {{0, 1, 2}}}));
  EXPECT_THROW(check(folder_ / "nan.ply"), InputError);
  EXPECT_THROW(check(folder_ / "mesh.stl"), InputError);
  EXPECT_THROW(check(folder_ / "missing.pvtp"), IoError);

  write_chunked(cube(), folder_ / "cube.pvtp", 5);
  const std::string chunk = file_bytes(folder_ / "cube/chunk_000001.vtp");
  put_bytes(folder_ / "cube/chunk_000001.vtp", chunk.substr(0, chunk.size() - 60));
  EXPECT_THROW(check(folder_ / "cube.pvtp"), InputError);
  std::filesystem::remove(folder_ / "cube/chunk_000001.vtp");
  EXPECT_THROW(check(folder_ / "cube.pvtp"), IoError);
}

TEST_F(MeshCheck, NothingIsLeftInTheScratchFolder) {
  write_chunked(torus(40, 30), folder_ / "mesh.pvtp", 500);
  const std::size_t before = folder_.names().size();
  check(folder_ / "mesh.pvtp");
  EXPECT_EQ(folder_.names().size(), before);
}

TEST(TriangleShape, FlatIsDecidedExactly) {
  // A third of a step aside of the line, and on it, where doubles cannot tell.
  const double third = 1.0 / 3;
  EXPECT_TRUE(is_flat({{{0.1, 0.1, 0.1}, {0.2, 0.2, 0.2}, {0.4, 0.4, 0.4}}}));
  EXPECT_FALSE(is_flat({{{0, 0, 0}, {1, third, 0}, {3, 1, 0}}}));
  EXPECT_TRUE(is_flat({{{0, 0, 0}, {1, third, 0}, {2, 2 * third, 0}}}));
  EXPECT_FALSE(is_flat({{{1e6, 1, 0}, {2e6, 2, 0}, {3e6, std::nextafter(3.0, 4), 0}}}));
  EXPECT_FALSE(is_flat({{{0, 0, 0}, {1e-200, 0, 0}, {0, 1e-200, 0}}}));
  EXPECT_FALSE(is_flat({{{0, 0, 0}, {0, 1e190, 0}, {0, 0, 1e190}}}));
  EXPECT_TRUE(is_flat({{{0, 0, 0}, {0, 0, 0}, {7, 1, 2}}}));
}

}  // namespace
}  // namespace stream_recon
