#include "io/vtp_mesh_reader.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "io/scalar_type.h"
#include "io/vtp_array_reader.h"

namespace stream_recon {
namespace {

/// The arrays of one piece; integers as they come, undivided.
struct Piece {
  VtpPiece counts;
  std::vector<Point3> points;
  std::vector<std::uint64_t> connectivity;
  std::vector<std::uint64_t> offsets;
  std::vector<float> delta;
  std::vector<std::uint8_t> source;
  std::vector<float> closure;
  std::vector<std::uint64_t> global_ids;
  std::vector<std::uint64_t> pole_ids;
  std::vector<std::uint32_t> sheets;
};

bool is_wanted(const VtpArray& array) {
  switch (array.section) {
    case VtpSection::kPoints:
      return true;
    case VtpSection::kPointData:
      return array.name == "GlobalPointId" || array.name == "PoleId" || array.name == "Sheet";
    case VtpSection::kCellData:
      return array.name == "Delta" || array.name == "Source" || array.name == "Closure";
    case VtpSection::kPolys:
      return array.name == "connectivity" || array.name == "offsets";
    case VtpSection::kOther:
      break;
  }
  return false;
}

class MeshReader {
 public:
  explicit MeshReader(const std::string& path) : source_(path), arrays_(source_, is_wanted) {
    if (!arrays_.is_poly_data()) source_.fail("not a surface; give a file of type PolyData");
  }

  VtpMesh read() {
    while (const std::optional<VtpArray> array = arrays_.next()) read_array(*array);
    VtpMesh mesh;
    for (const Piece& piece : pieces_) add(piece, mesh);
    return mesh;
  }

 private:
  Piece& piece_of(const VtpArray& array) {
    // A piece takes some hundred bytes of XML, so the list is never longer than the file.
    if (array.piece.index >= pieces_.size()) pieces_.resize(array.piece.index + 1);
    Piece& piece = pieces_[array.piece.index];
    piece.counts = array.piece;
    return piece;
  }

  void read_array(const VtpArray& array) {
    Piece& piece = piece_of(array);
    if (array.values == std::uint64_t{0}) return;
    if (array.section == VtpSection::kPoints) {
      read_points(array, piece.points);
    } else if (array.name == "connectivity") {
      read_integers(array, piece.connectivity);
    } else if (array.name == "offsets") {
      read_integers(array, piece.offsets);
    } else if (array.name == "GlobalPointId") {
      read_integers(array, piece.global_ids);
    } else if (array.name == "PoleId") {
      read_integers(array, piece.pole_ids);
    } else if (array.name == "Sheet") {
      read_values<std::uint32_t>(array, {ScalarType::kUint32, ScalarType::kInt32}, piece.sheets);
    } else if (array.name == "Delta") {
      read_values<float>(array, {ScalarType::kFloat32, ScalarType::kFloat32}, piece.delta);
    } else if (array.name == "Closure") {
      read_values<float>(array, {ScalarType::kFloat32, ScalarType::kFloat32}, piece.closure);
    } else {
      read_values<std::uint8_t>(array, {ScalarType::kUint8, ScalarType::kInt8}, piece.source);
    }
  }

  /// Appends all values, of one of two types that have T's size; grows as bytes arrive.
  template <typename T>
  void read_values(const VtpArray& array, std::array<ScalarType, 2> types, std::vector<T>& out) {
    if (array.type != types[0] && array.type != types[1]) {
      source_.fail("array " + array.name +
                   " is of another type than this program writes; "
                   "leave it out");
    }
    constexpr std::size_t kAtOnce = 4096;
    std::array<char, kAtOnce * sizeof(T)> bytes;
    std::size_t got = 0;
    do {
      got = arrays_.read(bytes);
      for (std::size_t at = 0; at + sizeof(T) <= got; at += sizeof(T)) {
        out.push_back(load_scalar<T>(bytes.data() + at, arrays_.order()));
      }
    } while (got == bytes.size());
    if (array.values && out.size() != *array.values) {
      source_.fail("array " + array.name + " has " + std::to_string(out.size()) + " values where " +
                   std::to_string(*array.values) + " are announced; the file is damaged");
    }
  }

  void read_integers(const VtpArray& array, std::vector<std::uint64_t>& out) {
    if (scalar_size(array.type) == 8) {
      return read_values<std::uint64_t>(array, {ScalarType::kInt64, ScalarType::kUint64}, out);
    }
    std::vector<std::uint32_t> narrow;
    read_values<std::uint32_t>(array, {ScalarType::kInt32, ScalarType::kUint32}, narrow);
    out.assign(narrow.begin(), narrow.end());
  }

  void read_points(const VtpArray& array, std::vector<Point3>& out) {
    if (array.components != 3) source_.fail("points need 3 components; the file is damaged");
    std::vector<double> values;
    if (array.type == ScalarType::kFloat32) {
      std::vector<float> narrow;
      read_values<float>(array, {ScalarType::kFloat32, ScalarType::kFloat32}, narrow);
      values.assign(narrow.begin(), narrow.end());
    } else {
      read_values<double>(array, {ScalarType::kFloat64, ScalarType::kFloat64}, values);
    }
    out.reserve(values.size() / 3);
    for (std::size_t i = 0; i < values.size(); i += 3) {
      out.push_back({values[i], values[i + 1], values[i + 2]});
    }
  }

  void add(const Piece& piece, VtpMesh& mesh) const {
    const VtpPiece& counts = piece.counts;
    if (counts.cells != counts.cells_before_polys + counts.polys) {
      source_.fail("triangle strips are not read; write triangles");
    }
    if (piece.points.size() != counts.points || piece.offsets.size() != counts.polys ||
        piece.connectivity.size() != 3 * counts.polys) {
      source_.fail("not all polygons are triangles, or an array is missing; triangulate the file");
    }
    const std::size_t base = mesh.points.size();
    mesh.points.insert(mesh.points.end(), piece.points.begin(), piece.points.end());
    for (std::size_t i = 0; i < piece.offsets.size(); ++i) {
      if (piece.offsets[i] != 3 * (i + 1)) {
        source_.fail("polygon " + std::to_string(i) + " is no triangle; triangulate the file");
      }
      std::array<std::uint32_t, 3> triangle{};
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const std::uint64_t point = piece.connectivity[3 * i + corner];
        if (point >= counts.points || base + point > UINT32_MAX) {
          source_.fail("triangle " + std::to_string(i) + " names point " + std::to_string(point) +
                       ", which is not there; the file is damaged");
        }
        triangle[corner] = static_cast<std::uint32_t>(base + point);
      }
      mesh.triangles.push_back(triangle);
    }
    append(piece.delta, counts.cells_before_polys, mesh.delta);
    append(piece.source, counts.cells_before_polys, mesh.source);
    append(piece.closure, counts.cells_before_polys, mesh.closure);
    append(piece.pole_ids.empty() ? piece.global_ids : piece.pole_ids, 0, mesh.global_ids);
    append(piece.sheets, 0, mesh.sheets);
    check_whole(mesh.delta.size(), mesh.triangles.size());
    check_whole(mesh.source.size(), mesh.triangles.size());
    check_whole(mesh.closure.size(), mesh.triangles.size());
    check_whole(mesh.global_ids.size(), mesh.points.size());
    check_whole(mesh.sheets.size(), mesh.points.size());
  }

  template <typename T>
  static void append(const std::vector<T>& from, std::uint64_t first, std::vector<T>& to) {
    if (from.size() > first) {
      to.insert(to.end(), from.begin() + static_cast<std::ptrdiff_t>(first), from.end());
    }
  }

  void check_whole(std::size_t values, std::size_t described) const {
    if (values != 0 && values != described) {
      source_.fail(
          "an array is there for some pieces only, or has several components; "
          "write it for all, with one component");
    }
  }

  ByteSource source_;
  VtpArrayReader arrays_;
  std::vector<Piece> pieces_;
};

}  // namespace

VtpMesh read_vtp_mesh(const std::string& path) {
  return MeshReader(path).read();
}

VtpMeshSize read_vtp_mesh_size(const std::string& path) {
  ByteSource source(path);
  VtpArrayReader arrays(source, is_wanted);
  VtpMeshSize size;
  std::size_t pieces = 0;
  const auto count = [&](const VtpArray& array) {
    size.has_global_ids = size.has_global_ids || array.name == "GlobalPointId";
    if (array.piece.index < pieces) return;
    pieces = array.piece.index + 1;
    size.points += array.piece.points;
    size.triangles += array.piece.polys;
  };
  while (const std::optional<VtpArray> array = arrays.next()) {
    if (array->storage == VtpStorage::kAppended) break;
    count(*array);
  }
  std::vector<VtpArray> appended(arrays.appended().begin(), arrays.appended().end());
  std::stable_sort(appended.begin(), appended.end(), [](const VtpArray& a, const VtpArray& b) {
    return a.piece.index < b.piece.index;
  });
  pieces = 0;
  for (const VtpArray& array : appended) count(array);
  return size;
}

}  // namespace stream_recon
