#include "engine/tetrahedra/tetrahedra_assembly.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "engine/order/point_store.h"
#include "engine/parallel.h"
#include "engine/tetrahedra/chunk_vertices.h"

namespace stream_recon {
namespace {

using LocalTetrahedron = std::array<std::uint32_t, 4>;

/// A block of an array, its compressed form, the compressor's tables; a point store's reader.
constexpr std::uint64_t kFixedBytes =
    (std::uint64_t{3} << 20) + record_file_memory(kPointStoreBlock);

/// By sorted corners; only the last two may be out of order. A type, for the sort to inline it.
struct BySortedCorners {
  bool operator()(const LocalTetrahedron& a, const LocalTetrahedron& b) const {
    if (a[0] != b[0]) return a[0] < b[0];
    if (a[1] != b[1]) return a[1] < b[1];
    return std::minmax(a[2], a[3]) < std::minmax(b[2], b[3]);
  }
};

class TetrahedraAssembly {
 public:
  TetrahedraAssembly(const ExportedTetrahedra& tetrahedra, TetrahedraWriter& writer,
                     const StageContext& context)
      : tetrahedra_(tetrahedra),
        writer_(writer),
        context_(context),
        fixed_memory_(context.budget.reserve(kFixedBytes, "writing tetrahedra")),
        store_(context.scratch, kPointStore) {}

  void run() {
    const ChunkLayout& layout = tetrahedra_.layout;
    context_.progress.begin_stage("tetrahedra", layout.point_count, "points");
    for (std::uint64_t chunk = 0; chunk < layout.chunk_count(); ++chunk) {
      context_.stop.check();
      if (tetrahedra_.records.count(chunk) != 0) assemble(chunk);
      context_.progress.advance(layout.end_rank(chunk) - layout.first_rank(chunk));
    }
    context_.progress.end_stage();
  }

 private:
  void assemble(std::uint64_t chunk) {
    Reservation memory = context_.budget.reserve(
        tetrahedra_.records.count(chunk) * sizeof(LocalTetrahedron), kHolder);
    writer_.write(make_chunk(chunk, memory));
  }

  /// What it needed besides the result is gone on return. \param memory has the tetrahedra
  TetrahedraChunk make_chunk(std::uint64_t chunk, Reservation& memory) {
    const ChunkLayout& layout = tetrahedra_.layout;
    ChunkVertices vertices(layout.first_rank(chunk), layout.end_rank(chunk), context_.budget);
    tetrahedra_.records.visit(chunk, [&](std::span<const TetrahedronRecord> records) {
      for (const TetrahedronRecord& record : records) {
        for (const PointRank rank : record.ranks) vertices.add(rank);
      }
    });
    vertices.number();
    memory.resize(memory.bytes() + vertices.size() * (sizeof(Point3) + sizeof(std::uint64_t)));
    TetrahedraChunk result;
    gather_points(vertices, result);
    gather_tetrahedra(chunk, vertices, result);
    return result;
  }

  void gather_points(const ChunkVertices& vertices, TetrahedraChunk& result) {
    result.points.reserve(vertices.size());
    result.global_ids.reserve(vertices.size());
    vertices.for_each([&](PointRank rank) {
      StoredPoint stored;
      store_.read_at(rank, {&stored, 1});
      result.points.push_back(stored.point);
      result.global_ids.push_back(stored.input_index);
    });
  }

  void gather_tetrahedra(std::uint64_t chunk, const ChunkVertices& vertices,
                         TetrahedraChunk& result) {
    result.tetrahedra.reserve(tetrahedra_.records.count(chunk));
    tetrahedra_.records.visit(chunk, [&](std::span<const TetrahedronRecord> records) {
      for (const TetrahedronRecord& record : records) {
        auto& tetrahedron = result.tetrahedra.emplace_back();
        for (int i = 0; i < 4; ++i) tetrahedron[i] = vertices.position(record.ranks[i]);
      }
    });
    // Positions ascend as ranks do.
    parallel_sort(result.tetrahedra.begin(), result.tetrahedra.end(), BySortedCorners());
  }

  static constexpr const char* kHolder =
      "a chunk of tetrahedra (a smaller --chunk-points needs less)";

  const ExportedTetrahedra& tetrahedra_;
  TetrahedraWriter& writer_;
  const StageContext& context_;
  Reservation fixed_memory_;
  PointStoreReader store_;
};

}  // namespace

void assemble_tetrahedra(const ExportedTetrahedra& tetrahedra, TetrahedraWriter& writer,
                         const StageContext& context) {
  TetrahedraAssembly(tetrahedra, writer, context).run();
}

}  // namespace stream_recon
