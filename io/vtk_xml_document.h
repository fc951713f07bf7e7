// A VTK XML file of one dataset: elements, and arrays appended behind them, raw and compressed.
//
// Guarantees: the bytes are a function of the elements and arrays, which stand in the order they
// were added in. Memory: the elements and one block of an array (vtk_xml_blocks.h): an array can be
// made while it is written. Thread rule: one thread. Layout: docs/formats.md.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/file.h"
#include "io/vtk_xml_blocks.h"

namespace stream_recon {

/// The attributes of <VTKFile> that all our XML files share.
extern const char* const kVtkXmlAttributes;

class VtkXmlDocument {
 public:
  /// Puts the bytes of an array, one piece after the other.
  using Fill = std::function<void(VtkXmlBlocks&)>;

  /// \param type of the dataset: "PolyData"
  explicit VtkXmlDocument(std::string type);

  void add(std::string_view elements) { head_ += elements; }
  /// An array of `raw_bytes` bytes, which `fill` puts when the document is written.
  void add_array(std::string_view attributes, std::uint64_t raw_bytes, Fill fill);
  /// An array in memory. \pre `raw` outlives write().
  void add_array(std::string_view attributes, std::span<const std::byte> raw);

  /// Writes all to `file`, new and empty. \throw IoError
  void write(VtkXmlBlocks& blocks, File& file);

 private:
  struct Array {
    std::size_t offset_at;  ///< position in the head of its place among the appended bytes
    std::uint64_t raw_bytes;
    Fill fill;
  };

  std::string type_;
  std::string head_;
  std::vector<Array> arrays_;
};

}  // namespace stream_recon
