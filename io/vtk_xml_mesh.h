// What the VTK XML files of surfaces, tetrahedra and medial axes have in common: points, ends of
// cells, index.
//
// Guarantees: the same elements and arrays in all. Memory: the text; arrays are made in pieces of
// 100 KB. Thread rule: pure functions. Layout: docs/formats.md.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/coordinates.h"
#include "io/vtk_xml_document.h"
#include "spatial/point.h"

namespace stream_recon {

struct VtkXmlPoints {
  std::span<const Point3> points;
  std::span<const std::uint64_t> global_ids;  ///< of each point
  Scalar scalar = Scalar::kFloat64;
  std::optional<std::span<const std::uint32_t>> sheets{};  ///< of each point, if there are any
};

/// Adds point data GlobalPointId, and Sheet, then the points. \pre The spans outlive
/// document.write().
void add_points(VtkXmlDocument& document, const VtkXmlPoints& points);

/// Adds the points alone. \pre The span outlives document.write().
void add_coordinates(VtkXmlDocument& document, std::span<const Point3> points, Scalar scalar);

/// Adds where each of `cells` cells of `corners` points ends in the list of corners.
/// \throw IoError more corners than 32 bits count
void add_cell_ends(VtkXmlDocument& document, std::uint64_t cells, std::uint32_t corners);

/// The whole file that names the pieces of a dataset.
struct VtkXmlIndex {
  std::string type;          ///< of the pieces: "PolyData"
  std::string point_data{};  ///< its PPointData element; empty: that of add_points()
  std::string cell_data;     ///< its PCellData element
  Scalar scalar = Scalar::kFloat64;
  bool has_sheets = false;
  std::vector<std::string> pieces;  ///< paths, relative to the index
};
std::string index_text(const VtkXmlIndex& index);

}  // namespace stream_recon
