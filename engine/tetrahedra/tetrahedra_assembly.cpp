#include "engine/tetrahedra/tetrahedra_assembly.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/chunks/chunk_loop.h"
#include "engine/chunks/chunk_numbers.h"
#include "engine/chunks/chunk_vertices.h"
#include "engine/order/point_store.h"
#include "engine/surface/buckets.h"

namespace stream_recon {
namespace {

using LocalTetrahedron = std::array<std::uint32_t, 4>;

/// A block of an array, its compressed form, the compressor's tables; a point store's cursor.
constexpr std::uint64_t kFixedBytes = std::uint64_t{3} << 20;
/// A vertex as it is written, and its rank.
constexpr std::uint64_t kPointBytes = sizeof(Point3) + sizeof(std::uint64_t) + sizeof(PointRank);
/// What a tetrahedron may be expected to need: its vertices are shared by about seven.
constexpr std::uint64_t kTypicalBytes = sizeof(LocalTetrahedron) + (kPointBytes + 16) / 6;

/// By sorted corners; only the last two may be out of order. A type, for the sort to inline it.
struct BySortedCorners {
  bool operator()(const LocalTetrahedron& a, const LocalTetrahedron& b) const {
    if (a[0] != b[0]) return a[0] < b[0];
    if (a[1] != b[1]) return a[1] < b[1];
    return std::minmax(a[2], a[3]) < std::minmax(b[2], b[3]);
  }
};

struct ChunkTetrahedra {
  Reservation memory;
  TetrahedraChunk chunk;
};

class TetrahedraAssembly {
 public:
  TetrahedraAssembly(const ExportedTetrahedra& tetrahedra, TetrahedraWriter& writer,
                     const StageContext& context)
      : tetrahedra_(tetrahedra),
        writer_(writer),
        context_(context),
        numbers_(tetrahedra.records, tetrahedra.layout.chunk_count(), context.budget),
        store_(context.scratch.open(kPointStore)) {}

  void run() {
    const ChunkLayout& layout = tetrahedra_.layout;
    context_.progress.begin_stage("tetrahedra", layout.point_count, "points");
    const std::uint64_t bytes =
        numbers_.most_records() * kTypicalBytes + kFixedBytes + ExportReader::read_memory();
    for_each_chunk(
        {.chunks = layout.chunk_count(), .at_once = chunks_at_once(bytes, context_.budget)},
        [this](std::uint64_t chunk) { return make(chunk); },
        [this](std::uint64_t chunk, const ChunkTetrahedra& made) { take(chunk, made); });
    context_.progress.end_stage();
  }

 private:
  void take(std::uint64_t chunk, const ChunkTetrahedra& made) {
    if (!made.chunk.tetrahedra.empty()) writer_.write(numbers_.number(chunk), made.chunk);
    context_.progress.advance(tetrahedra_.layout.points_in(chunk));
  }

  ChunkTetrahedra make(std::uint64_t chunk) const {
    context_.stop.check();
    ChunkTetrahedra result;
    const std::uint64_t count = tetrahedra_.records.count(chunk);
    if (count == 0) return result;
    const ChunkLayout& layout = tetrahedra_.layout;
    const PointRank first = layout.first_rank(chunk);
    const std::uint64_t points = layout.end_rank(chunk) - first;
    result.memory = context_.budget.reserve(
        kFixedBytes + count * sizeof(LocalTetrahedron) + points * sizeof(std::uint32_t), kHolder);
    ChunkVertices vertices(first, first + points, context_.budget);
    // A tetrahedron's lowest vertex lies in the chunk, and few share it.
    Buckets by_lowest(points);
    visit(chunk, [&](const TetrahedronRecord& record) {
      for (const PointRank rank : record.ranks) vertices.add(rank);
      by_lowest.count(record.ranks[0] - first);
    });
    vertices.number();
    by_lowest.start();
    result.memory.resize(result.memory.bytes() + vertices.size() * kPointBytes);
    auto& cells = result.chunk.tetrahedra;
    cells.resize(count);
    visit(chunk, [&](const TetrahedronRecord& record) {
      LocalTetrahedron& cell = cells[by_lowest.slot(record.ranks[0] - first)];
      for (int i = 0; i < 4; ++i) cell[i] = vertices.position(record.ranks[i]);
    });
    // Positions ascend as ranks do.
    by_lowest.for_each([&cells](std::uint32_t begin, std::uint32_t end) {
      std::sort(cells.begin() + begin, cells.begin() + end, BySortedCorners());
    });
    read_points(store_, vertices.ranks(), result.chunk.points, result.chunk.global_ids);
    return result;
  }

  template <class Visit>
  void visit(std::uint64_t chunk, const Visit& visit) const {
    tetrahedra_.records.visit(chunk, [&visit](std::span<const TetrahedronRecord> records) {
      for (const TetrahedronRecord& record : records) visit(record);
    });
  }

  static constexpr const char* kHolder =
      "a chunk of tetrahedra (a smaller --chunk-points needs less)";

  const ExportedTetrahedra& tetrahedra_;
  TetrahedraWriter& writer_;
  const StageContext& context_;
  ChunkNumbers numbers_;
  PointStoreFile store_;
};

}  // namespace

void assemble_tetrahedra(const ExportedTetrahedra& tetrahedra, TetrahedraWriter& writer,
                         const StageContext& context) {
  TetrahedraAssembly(tetrahedra, writer, context).run();
}

}  // namespace stream_recon
