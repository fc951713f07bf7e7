// What a window hands on to later stages, on disk: one record file a window.
//
// Guarantees: the records of all kinds, each in 32 bytes, in parts of one kind and chunk; then the
// table of the parts; last the tail. Layout: docs/formats.md. Thread rule: values.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

namespace stream_recon {

enum class ExportKind : std::uint32_t {
  kFacets,
  kBorderPoints,
  kBorderEdges,
  kTetrahedra,
  kBorderFacets,
  kEvidenceNodes,
  kEvidenceEdges,
  kCandidates,
  kPoleNames,
  kPoleBalls,
};
inline constexpr std::size_t kExportKinds = 10;

/// A record of any kind; shorter ones are filled with zeros.
using ExportRecord = std::array<std::byte, 32>;

template <class Record>
concept ExportableRecord = std::is_trivially_copyable_v<Record> &&
                           sizeof(Record) <= sizeof(ExportRecord);

/// Consecutive records of one kind that belong to one chunk.
struct ExportPart {
  std::uint64_t chunk = 0;
  std::uint64_t first = 0;  ///< record of the file
  std::uint32_t count = 0;
  ExportKind kind{};
  std::uint64_t unused = 0;
};

struct ExportTail {
  static constexpr std::uint64_t kMark = 0x5354524f50584521;  ///< "!EXPORTS"

  std::uint64_t mark = kMark;
  std::uint64_t parts = 0;
  std::uint64_t records = 0;  ///< of all parts
  std::uint64_t unused = 0;
};

static_assert(sizeof(ExportPart) == sizeof(ExportRecord));
static_assert(sizeof(ExportTail) == sizeof(ExportRecord));

inline constexpr std::size_t kExportBlock = std::size_t{128} << 10;

/// Exports are files of this name and the window's first rank.
inline constexpr std::string_view kExportPrefix = "window_";
/// What later stages make of them has names of its own.
inline constexpr std::string_view kLabelledPrefix = "labelled_";

inline std::string export_name(std::uint64_t first_rank, std::string_view prefix = kExportPrefix) {
  return std::string(prefix) + std::to_string(first_rank);
}

/// Of the window whose export has this name; nothing if it is no export's.
std::optional<std::uint64_t> export_first_rank(std::string_view name,
                                               std::string_view prefix = kExportPrefix);

}  // namespace stream_recon
