#include "io/point_source.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "io/byte_source.h"
#include "io/ply_reader.h"
#include "io/pts_layout.h"
#include "io/pts_reader.h"
#include "io/raw_reader.h"
#include "io/vtk_legacy_reader.h"
#include "io/vtp_reader.h"
#include "io/xyz_reader.h"

namespace stream_recon {
namespace {

constexpr std::size_t kSniffed = 64;

void refuse_compressed(const ByteSource& source, std::string_view head) {
  const auto refuse = [&](const char* kind, const char* tool) {
    source.fail(std::string("the input is compressed with ") + kind + "; pipe it through: " + tool +
                " -dc FILE | stream-recon - ...");
  };
  if (head.starts_with("\x28\xB5\x2F\xFD")) refuse("zstd", "zstd");
  if (head.starts_with("\x1F\x8B")) refuse("gzip", "gzip");
  if (head.starts_with(std::string_view("\xFD\x37zXZ\0", 6))) refuse("xz", "xz");
  if (head.starts_with("BZh")) refuse("bzip2", "bzip2");
}

bool is_text(std::string_view head) {
  return std::all_of(head.begin(), head.end(), [](char c) {
    const auto code = static_cast<unsigned char>(c);
    return (code >= 0x20 && code != 0x7f) || (code >= '\t' && code <= '\r');
  });
}

/// The format the first bytes show; kAuto where they show none.
InputFormat format_of_bytes(std::string_view head) {
  if (head.starts_with("ply\n") || head.starts_with("ply\r") || head.starts_with("ply ")) {
    return InputFormat::kPly;
  }
  if (head.starts_with(kPtsMagic)) return InputFormat::kPts;
  if (head.starts_with("# vtk DataFile")) return InputFormat::kVtk;
  if (head.starts_with("\xEF\xBB\xBF")) head.remove_prefix(3);
  const std::size_t first = std::min(head.find_first_not_of(" \t\r\n"), head.size());
  const std::string_view content = head.substr(first);
  if (content.starts_with("<?xml") || content.starts_with("<VTKFile")) return InputFormat::kVtp;
  return is_text(head) ? InputFormat::kXyz : InputFormat::kAuto;
}

InputFormat format_of(ByteSource& source, const std::string& path, std::string_view head) {
  if (path.ends_with(".f32")) return InputFormat::kF32;
  if (path.ends_with(".f64")) return InputFormat::kF64;
  if (head.empty()) source.fail("the input is empty; give a file with points");
  refuse_compressed(source, head);
  const InputFormat format = format_of_bytes(head);
  if (format == InputFormat::kAuto) {
    source.fail("the first bytes show no known format; name it with --input-format");
  }
  return format;
}

}  // namespace

const PointMetadata& PointSource::metadata() const {
  static const PointMetadata nothing;
  return nothing;
}

std::unique_ptr<PointSource> open_point_source(const std::string& path, InputFormat format) {
  auto source = std::make_unique<ByteSource>(path);
  if (format != InputFormat::kF32 && format != InputFormat::kF64) {
    const std::string_view head = source->peek(kSniffed).substr(0, kSniffed);
    if (format == InputFormat::kAuto) {
      format = format_of(*source, path, head);
    } else {
      refuse_compressed(*source, head);
    }
  }
  switch (format) {
    case InputFormat::kPly:
      return make_ply_source(std::move(source));
    case InputFormat::kF32:
      return make_raw_source(std::move(source), ScalarType::kFloat32);
    case InputFormat::kF64:
      return make_raw_source(std::move(source), ScalarType::kFloat64);
    case InputFormat::kVtk:
      return make_vtk_legacy_source(std::move(source));
    case InputFormat::kVtp:
      return make_vtp_source(std::move(source));
    case InputFormat::kPts:
      return make_pts_source(std::move(source));
    case InputFormat::kXyz:
    case InputFormat::kAuto:
      break;
  }
  return make_xyz_source(std::move(source));
}

}  // namespace stream_recon
