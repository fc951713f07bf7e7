#include "io_reader_cases.h"

#include <array>
#include <limits>

#include "io/pts_encoder.h"
#include "io_reader_helpers.h"

namespace stream_recon {
namespace {

// What every number type of 32 bits and more holds, and what a float holds.
constexpr std::array<double, 9> kWhole{1, -2, 3, 40000, 0, -70000, 7, 8, 123456};
constexpr std::array<double, 9> kSingle{0.5,  -2.25,  3e10F,    1.0F / 3, 0,
                                        -0.0, 1e-40F, 16777216, 0.1F};

std::vector<Point3> points_of(std::span<const double> values) {
  std::vector<Point3> points;
  for (std::size_t i = 0; i + 2 < values.size(); i += 3) {
    points.push_back({values[i], values[i + 1], values[i + 2]});
  }
  return points;
}

ReaderCase made(std::string name, InputFormat format, const std::string& header,
                const std::string& body, std::span<const double> values) {
  return {std::move(name), format, header + body, points_of(values), header.size()};
}

void add_ply(std::vector<ReaderCase>& cases) {
  const std::string ascii_header =
      "ply\nformat ascii 1.0\ncomment made by hand\nobj_info none\nelement camera 2\n"
      "property list uchar int pixels\nelement vertex 3\nproperty uchar red\nproperty float x\n"
      "property list uchar short extra\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  cases.push_back(made("ply_ascii", InputFormat::kPly, ascii_header + "2 7 8\n0\n",
                       "255 0.5 0 -2.25 3e10\n1 0.33333334 2 4 5 0 -0\n0\t1e-40 1 9 16777216 0.1 "
                       "\n3 0 1 2\n",
                       kSingle));
  std::string windows = cases.back().bytes;
  for (std::size_t at = 0; (at = windows.find('\n', at)) != std::string::npos; at += 2) {
    windows.replace(at, 1, "\r\n");
  }
  cases.push_back(made("ply_ascii_crlf", InputFormat::kPly, windows, "", kSingle));
  cases.back().header = windows.find("end_header");
  for (const bool big : {false, true}) {
    const std::string order = big ? "big" : "little";
    const std::string start = "ply\nformat binary_" + order + "_endian 1.0\n";
    cases.push_back(made("ply_float_" + order, InputFormat::kPly,
                         start + "element vertex 3\nproperty float x\nproperty float y\n"
                                 "property float z\nend_header\n",
                         packed<float>(kSingle, big), kSingle));
    cases.push_back(made("ply_int_crlf_" + order, InputFormat::kPly,
                         "ply\r\nformat binary_" + order +
                             "_endian 1.0\r\nelement vertex 3\r\nproperty int32 x\r\n"
                             "property int y\r\nproperty int z\r\nend_header\r\n",
                         packed<std::int32_t>(kWhole, big), kWhole));
    std::string lists;
    std::string plain;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::span<const double> point = std::span(kSingle).subspan(3 * i, 3);
      const std::array<double, 1> length{static_cast<double>(i)};
      lists += packed<double>(point.first(1), big) + packed<std::uint16_t>(length, big) +
               std::string(4 * i, '\x7f') + packed<double>(point.subspan(1), big);
      plain += std::string(3, '\xff') + packed<double>(point.last(1), big) +
               packed<double>(point.first(2), big);
    }
    cases.push_back(made("ply_lists_" + order, InputFormat::kPly,
                         start + "element vertex 3\nproperty double x\n"
                                 "property list ushort float weights\nproperty double y\n"
                                 "property double z\nend_header\n",
                         lists, kSingle));
    const std::array<double, 5> pairs{1, 2, 2, 3, 9};
    cases.push_back(made("ply_between_" + order, InputFormat::kPly,
                         start +
                             "element pair 2\nproperty list uint8 uint8 items\nelement empty 5\n"
                             "element vertex 3\nproperty uchar r\nproperty uint16 s\n"
                             "property float64 z\nproperty float64 x\nproperty float64 y\n"
                             "element face 7\nproperty list uchar int vertex_indices\n"
                             "end_header\n" +
                             packed<std::uint8_t>(pairs, big),
                         plain, kSingle));
    cases.back().bytes += '\x03';
  }
}

void add_text(std::vector<ReaderCase>& cases) {
  const std::array<double, 9> values{0.1, -2.25, 3e10, 1.0 / 3, 0, -0.0, 1e-320, 16777217, 1e300};
  const auto add = [&](const std::string& name, const std::string& header,
                       const std::string& body) {
    cases.push_back(made("xyz_" + name, InputFormat::kXyz, header, body, values));
    cases.back().counted = false;
  };
  add("plain", "", "0.1 -2.25 3e10\n0.33333333333333331 0 -0\n1e-320 16777217 +1E300\n");
  add("commas", "", "0.1,-2.25,3e10\n0.33333333333333331, 0 ,-0\r\n\n1e-320\t,16777217, 1e300,9\n");
  add("semicolons", "# x y z\n",
      "0.1;-2.25;3e10;;\n0.33333333333333331;0;-0;;\n1e-320;16777217;1e300;;\n");
  add("comments", "\xEF\xBB\xBF// a cloud\n\n",
      "  0.1\t-2.25  3e10 255 0 0 name\n # and\n0.33333333333333331 0 -0 1 2 3 name # here\n//\n"
      "1e-320 16777217 1e300 1 2 3 name\n\n");
  add("named", "id,\"y\", X ,z\n",
      "1,-2.25,0.1,3e10\nb,0,0.33333333333333331,-0\n,16777217,1e-320,1e300\n");
  add("named_in_comment", "// made by hand\n#id x y z\n",
      "1 0.1 -2.25 3e10\n2 0.33333333333333331 0 -0\n3 1e-320 16777217 1e300\n");
  add("counted", "3\n", "0.1 -2.25 3e10\n0.33333333333333331 0 -0\n1e-320 16777217 1e300\n");
  cases.back().counted = true;
}

void add_raw(std::vector<ReaderCase>& cases) {
  cases.push_back(made("raw_f32", InputFormat::kF32, "", packed<float>(kSingle, false), kSingle));
  cases.push_back(made("raw_f64", InputFormat::kF64, "", packed<double>(kSingle, false), kSingle));
  for (std::size_t i = cases.size() - 2; i < cases.size(); ++i) cases[i].counted = false;
}

void add_legacy(std::vector<ReaderCase>& cases) {
  const std::string field =
      "FIELD FieldData 2\nnote 1 2 string\nhello%20world\n\nTIME 1 1 double\n1.5 \nMETADATA\n"
      "COMPONENT_NAMES\nt\n\n";
  const std::string start = "# vtk DataFile Version 5.1\nvtk output\n";
  cases.push_back(made("vtk_ascii", InputFormat::kVtk,
                       start + "ASCII\nDATASET POLYDATA\n" + field + "POINTS 3 float\n",
                       "0.5 -2.25 3e10 0.33333334 0 \n-0 1e-40 16777216 0.1 \n\nMETADATA\n",
                       kSingle));
  cases.push_back(made("vtk_grid", InputFormat::kVtk,
                       "# vtk DataFile Version 2.0\nx\nASCII\nDATASET STRUCTURED_GRID\n"
                       "DIMENSIONS 3 1 1\nPOINTS 3 int\n",
                       "1 -2 3 40000 0 -70000 7 8 123456\n", kWhole));
  const std::string binary_field =
      "FIELD FieldData 2\nnote 1 2 string\n\xC5hello\xC0\nTIME 2 1 "
      "float\n" +
      std::string(8, '\n') + "\nMETADATA\nNAMES\n\n";
  cases.push_back(
      made("vtk_binary_float", InputFormat::kVtk,
           start + "BINARY\nDATASET UNSTRUCTURED_GRID\n" + binary_field + "POINTS 3 float\n",
           packed<float>(kSingle, true), kSingle));
  cases.push_back(made("vtk_binary_double", InputFormat::kVtk,
                       "# vtk DataFile Version 3.0\r\nx\r\nbinary\r\ndataset polydata\r\n"
                       "points 3 double\r\n",
                       packed<double>(kSingle, true) + "\nVERTICES 1 2\n", kSingle));
  cases.push_back(made("vtk_binary_short", InputFormat::kVtk,
                       start + "BINARY\nDATASET POLYDATA\nPOINTS 2 short\n",
                       packed<std::int16_t>(std::array<double, 6>{1, -2, 3, 4, -5, 32767}, true),
                       std::array<double, 6>{1, -2, 3, 4, -5, 32767}));
}

std::string base64(const std::string& bytes) {
  constexpr std::string_view kAlphabet =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    unsigned group = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      group = group << 8 | (at + i < bytes.size() ? static_cast<unsigned char>(bytes[at + i]) : 0U);
    }
    for (std::size_t i = 0; i < 4; ++i) {
      text += at + i > bytes.size() ? '=' : kAlphabet[group >> (18 - 6 * i) & 63];
    }
  }
  return text;
}

/// A file with one piece; `array` is the attributes of Points, `content` what stands inside it.
std::string vtp(const std::string& root, const std::string& array, const std::string& content) {
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" " + root +
         ">\n<PolyData>\n<FieldData><DataArray type=\"Int8\" Name=\"t\" format=\"ascii\">1 2"
         "</DataArray></FieldData><Piece NumberOfPoints=\"3\" NumberOfPolys=\"0\">\n<PointData>"
         "<DataArray type=\"UInt8\" Name=\"Points\" format=\"ascii\">1 2 3</DataArray>"
         "</PointData><Points>\n<DataArray Name=\"Points\" NumberOfComponents=\"3\" " +
         array + ">" + content + "</DataArray></Points></Piece></PolyData>";
}

void add_vtp(std::vector<ReaderCase>& cases) {
  const std::string little = "byte_order=\"LittleEndian\"";
  const std::string big = "byte_order=\"BigEndian\" header_type=\"UInt64\"";
  const std::string end = "</VTKFile>\n";
  const auto add = [&](const std::string& name, const std::string& head, const std::string& rest) {
    cases.push_back(made("vtp_" + name, InputFormat::kVtp, head, rest, kSingle));
  };
  add("ascii",
      vtp(little, "type=\"Float32\" format=\"ascii\"",
          "\n0.5 -2.25 3e10 0.33333334 0\n-0 1e-40 16777216 0.1 <InformationKey "
          "name=\"a\">7 <Value>8</Value></InformationKey>\n"),
      end);
  const std::string content = packed<float>(kSingle, false);
  const std::string length = packed<std::uint32_t>(std::array<double, 1>{36}, false);
  add("base64",
      vtp(little, "type=\"Float32\" format=\"binary\"", "\n  " + base64(length + content)), end);
  const std::string wide =
      packed<std::uint64_t>(std::array<double, 1>{72}, true) + packed<double>(kSingle, true);
  add("raw",
      vtp(big, "type=\"Float64\" format=\"appended\" offset=\"5\"", "") +
          "<AppendedData encoding=\"raw\">\n   _<a>&\x01",
      wide + "\n</AppendedData>" + end);
  add("appended_base64",
      vtp(big, "type=\"Float64\" format=\"appended\" offset=\"8\"", "") +
          "<AppendedData encoding=\"base64\">_QUJDREU=",
      base64(wide) + "</AppendedData>" + end);
  // Two blocks of 32 and 4 bytes, as VTK 9.1 compresses them.
  add("zlib",
      vtp(little + " compressor=\"vtkZLibDataCompressor\"", "type=\"Float32\" format=\"binary\"",
          "AgAAACAAAAAEAAAAIgAAAAwAAAA="
          "eJxjYGCwZ2AQOFDWcj9g9apVdgwQ0HBIjBFEeQMAgtAHmnicO3vmjC0AB3ECow=="),
      end);
  add("lz4",
      vtp(little + " compressor=\"vtkLZ4DataCompressor\"", "type=\"Float32\" format=\"binary\"",
          "AgAAACAAAAAEAAAAHwAAAAUAAAA=8gIAAAA/AAAQwHaE31Crqqo+AAEAkIDCFgEAAACAS0DNzMw9"),
      end);
}

void add_pts(std::vector<ReaderCase>& cases) {
  const std::vector<Point3> points = points_of(kSingle);
  for (const Scalar scalar : {Scalar::kFloat32, Scalar::kFloat64}) {
    PtsEncoder encoder(scalar);
    const std::string header = encoder.header({SampleSpacing{1, 1, 1.5}, "a folder", "label 13"});
    std::string frames = encoder.frame(std::span(points).first(1));
    frames += encoder.frame(std::span(points).subspan(1));
    frames += encoder.end();
    cases.push_back(made(scalar == Scalar::kFloat32 ? "pts_float" : "pts_double", InputFormat::kPts,
                         header, frames, kSingle));
  }
}

}  // namespace

std::vector<ReaderCase> reader_cases() {
  std::vector<ReaderCase> cases;
  add_ply(cases);
  add_text(cases);
  add_raw(cases);
  add_legacy(cases);
  add_vtp(cases);
  add_pts(cases);
  return cases;
}

}  // namespace stream_recon
