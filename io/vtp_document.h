// The XML side of a VTK XML file (PolyData, UnstructuredGrid): which arrays there are, and where.
//
// Guarantees: arrays come in the order of the file; the XML is read as far as the array returned,
// so its content can follow. Memory: that of XmlReader. Thread rule: one reader.
// Source: "VTK File Formats" (Kitware), XML formats.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "io/byte_source.h"
#include "io/vtp_stream.h"
#include "io/xml_reader.h"

namespace stream_recon {

enum class VtpSection { kPoints, kPointData, kCellData, kPolys, kOther };
enum class VtpStorage { kNumbers, kBase64, kAppended };

struct VtpPiece {
  std::size_t index = 0;  ///< from 0, in the order of the file
  std::uint64_t points = 0;
  std::uint64_t cells_before_polys = 0;  ///< vertices and lines
  std::uint64_t polys = 0;
  std::uint64_t cells = 0;
};

struct VtpArray {
  VtpPiece piece;
  VtpSection section = VtpSection::kOther;
  std::string name;
  ScalarType type = ScalarType::kFloat32;
  std::uint64_t components = 1;
  std::optional<std::uint64_t> values;  ///< in the array, where the piece's counts tell
  VtpStorage storage = VtpStorage::kNumbers;
  std::uint64_t offset = 0;  ///< of an appended array in its section
};

class VtpDocument : private VtpText {
 public:
  /// Reads up to the dataset. \throw InputError no VTK XML file of a known kind; IoError
  explicit VtpDocument(ByteSource& source);

  const VtpEncoding& encoding() const { return encoding_; }
  bool is_poly_data() const { return is_poly_data_; }

  /// The next array of a piece; nothing at an appended section or at the end.
  /// \throw InputError, IoError
  std::optional<VtpArray> next();

  /// The characters inside the array that next() gave.
  VtpText& text() { return *this; }

  /// Once next() gave nothing: how the appended section is stored that the source stands in,
  /// behind its tag; nothing if there is none. kBase64, or kAppended for raw bytes.
  std::optional<VtpStorage> appended() const { return appended_; }

 private:
  std::string_view peek() override;
  void consume(std::size_t count) override { text_begin_ += count; }

  void read_encoding(const XmlEvent& root);
  void start_piece(const XmlEvent& event);
  VtpArray describe(const XmlEvent& event) const;
  std::optional<std::uint64_t> values_of(const VtpArray& array) const;
  std::uint64_t count_of(const XmlEvent& event, const char* attribute) const;

  ByteSource& source_;
  XmlReader xml_;
  VtpEncoding encoding_;
  bool is_poly_data_ = false;
  VtpPiece piece_;
  std::size_t pieces_ = 0;
  bool in_piece_ = false;
  VtpSection section_ = VtpSection::kOther;
  std::optional<VtpStorage> appended_;
  bool finished_ = false;
  int array_depth_ = 0;  ///< elements open from the current array on; 0 behind it
  XmlEvent text_;
  std::size_t text_begin_ = 0;
};

}  // namespace stream_recon
