#include "tools/slices/dicom_header.h"

#include <fmt/format.h>
#include <gdcmReader.h>

#include <cmath>
#include <set>
#include <sstream>
#include <vector>

#include "io/error.h"
#include "io/scalar_type.h"
#include "tools/slices/itk_file.h"
#include "tools/slices/slice_image.h"
#include "tools/slices/unpacked_file.h"

namespace stream_recon {
namespace {

const gdcm::Tag kPixels(0x7fe0, 0x0010);

class Elements {
 public:
  explicit Elements(const gdcm::DataSet& elements) : elements_(elements) {}

  std::string text(const gdcm::Tag& tag) const {
    if (!elements_.FindDataElement(tag)) return "";
    const gdcm::ByteValue* value = elements_.GetDataElement(tag).GetByteValue();
    if (value == nullptr) return "";
    std::string text(value->GetPointer(), value->GetLength());
    while (!text.empty() && (text.back() == ' ' || text.back() == '\0')) text.pop_back();
    return text;
  }

  /// Decimal numbers with backslashes between; nothing unless there are `count`.
  std::vector<double> numbers(const gdcm::Tag& tag, std::size_t count) const {
    std::istringstream words(text(tag));
    std::vector<double> values;
    for (std::string word; std::getline(words, word, '\\');) {
      const double value = std::strtod(word.c_str(), nullptr);
      if (!std::isfinite(value)) return {};
      values.push_back(value);
    }
    return values.size() == count ? values : std::vector<double>();
  }

  /// GDCM has turned the bytes into the order of this machine.
  std::size_t number16(const gdcm::Tag& tag) const {
    if (!elements_.FindDataElement(tag)) return 0;
    const gdcm::ByteValue* value = elements_.GetDataElement(tag).GetByteValue();
    if (value == nullptr || value->GetLength() < 2) return 0;
    return load_scalar<std::uint16_t>(value->GetPointer(), std::endian::native);
  }

  bool has(const gdcm::Tag& tag) const { return elements_.FindDataElement(tag); }

 private:
  const gdcm::DataSet& elements_;
};

DicomHeader header_of(const gdcm::DataSet& data) {
  const Elements elements(data);
  DicomHeader header;
  header.series = elements.text({0x0020, 0x000e});
  header.description = elements.text({0x0008, 0x103e});
  header.rows = elements.number16({0x0028, 0x0010});
  header.columns = elements.number16({0x0028, 0x0011});
  header.is_directory = elements.has({0x0004, 0x1220});
  const auto frames = elements.numbers({0x0028, 0x0008}, 1);
  if (!frames.empty() && frames[0] >= 1) header.frames = static_cast<std::size_t>(frames[0]);
  if (const auto p = elements.numbers({0x0020, 0x0032}, 3); !p.empty())
    header.position = Point3{p[0], p[1], p[2]};
  if (const auto a = elements.numbers({0x0020, 0x0037}, 6); !a.empty())
    header.axes = {{{a[0], a[1], a[2]}, {a[3], a[4], a[5]}}};
  for (const gdcm::Tag& tag : {gdcm::Tag(0x0028, 0x0030), gdcm::Tag(0x0018, 0x1164)}) {
    const auto spacing = elements.numbers(tag, 2);  // down a column first
    if (header.pixel_spacing || spacing.empty() || !(spacing[0] > 0) || !(spacing[1] > 0)) continue;
    header.pixel_spacing = {spacing[1], spacing[0]};
  }
  return header;
}

bool is_named_as_dicom(const std::string& path) {
  static const std::set<std::string> kEndings{".dcm", ".dicom", ".ima"};
  return kEndings.contains(lower_ending(path));
}

}  // namespace

bool is_dicom(const std::string& path) {
  std::array<char, 132> bytes{};
  UnpackedFile(path, Packing::kNone, 0).read(std::as_writable_bytes(std::span(bytes)));
  if (std::string_view(&bytes[128], 4) == "DICM") return true;
  if (!is_named_as_dicom(path)) return false;
  bool is_readable = false;
  call_itk(path, [&] {
    gdcm::Reader reader;
    reader.SetFileName(path.c_str());
    is_readable = reader.CanRead();
  });
  return is_readable;
}

DicomHeader read_dicom_header(const std::string& path) {
  gdcm::Reader reader;
  reader.SetFileName(path.c_str());
  bool is_read = false;
  call_itk(path, [&] { is_read = reader.ReadUpToTag(kPixels, {}); });
  if (!is_read) {
    throw InputError(
        fmt::format("{}: truncated or damaged DICOM header; copy the file again", path));
  }
  DicomHeader header = header_of(reader.GetFile().GetDataSet());
  header.path = path;
  return header;
}

}  // namespace stream_recon
