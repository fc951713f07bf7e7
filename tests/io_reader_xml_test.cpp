// XML as a stream: where it stops, what it refuses; the surface chunk and its index.
#include <gtest/gtest.h>

#include "io/byte_source.h"
#include "io/pvtp_index.h"
#include "io/vtp_mesh_reader.h"
#include "io/xml_reader.h"
#include "io_reader_helpers.h"

namespace stream_recon {
namespace {

std::string error_of_xml(const std::string& text) {
  const ByteFile file;
  file.put(text);
  ByteSource source(file.path());
  XmlReader xml(source);
  try {
    while (xml.next().kind != XmlEvent::Kind::kFinished) {
    }
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Xml, StopsRightBehindTheTagItReturned) {
  const ByteFile file;
  const std::string before = "<a><b c=\"&lt;1&gt;\">t</b><!-- <x> --><d e='1'>";
  file.put(before + "\x01<&>");
  ByteSource source(file.path());
  XmlReader xml(source);
  XmlEvent event = xml.next();
  while (event.name != "d") event = xml.next();
  EXPECT_EQ(source.offset(), before.size());
  EXPECT_EQ(event.attribute("e"), "1");
  EXPECT_EQ(source.peek(1), "\x01<&>");
}

TEST(Xml, RefusesBombs) {
  EXPECT_NE(error_of_xml("<!DOCTYPE a [<!ENTITY b \"bb\">]><a>&b;</a>").find("type declaration"),
            std::string::npos);
  std::string deep;
  for (int i = 0; i < 100; ++i) deep += "<a>";
  EXPECT_NE(error_of_xml(deep).find("too deep"), std::string::npos);
  EXPECT_NE(error_of_xml("<a b=\"" + std::string(1 << 20, 'x') + "\"/>").find("does not end"),
            std::string::npos);
}

TEST(Xml, RefusesWhatIsNotWellFormed) {
  for (const char* text : {"", "a", "<a>", "<a></b>", "<a b=1/>", "<a/><b/>", "<a>&x;</a>", "<a"}) {
    EXPECT_NE(error_of_xml(text), "") << text;
  }
  EXPECT_EQ(error_of_xml("<a> b <!-- c > --> <![CDATA[ < > ]]> </a> "), "");
}

class Chunk : public ::testing::Test {
 protected:
  VtpMesh read(const std::string& pieces) {
    file_.put("<VTKFile type=\"PolyData\" byte_order=\"LittleEndian\"><PolyData>" + pieces +
              "</PolyData></VTKFile>");
    return read_vtp_mesh(file_.path());
  }
  static std::string piece(const std::string& connectivity, const std::string& offsets,
                           const std::string& more = "") {
    return "<Piece NumberOfPoints=\"4\" NumberOfVerts=\"1\" NumberOfPolys=\"2\">" + more +
           "<Points><DataArray type=\"Float64\" NumberOfComponents=\"3\">0 0 0 1 0 0 0 1 0 0.1 0.2 "
           "0.3</DataArray></Points><Verts><DataArray type=\"Int32\" Name=\"connectivity\">0"
           "</DataArray></Verts><Polys><DataArray type=\"Int32\" Name=\"connectivity\">" +
           connectivity + "</DataArray><DataArray type=\"Int64\" Name=\"offsets\">" + offsets +
           "</DataArray></Polys></Piece>";
  }
  ByteFile file_;
};

TEST_F(Chunk, IsReadWithItsArrays) {
  const VtpMesh mesh =
      read(piece("0 1 2 3 1 2", "3 6",
                 "<PointData><DataArray type=\"Int64\" Name=\"GlobalPointId\">5 7 6 9"
                 "</DataArray></PointData><CellData><DataArray type=\"Float32\" Name=\"Delta\">"
                 "0 60.5 70</DataArray><DataArray type=\"UInt8\" Name=\"Source\">9 0 1</DataArray>"
                 "</CellData>"));
  EXPECT_EQ(mesh.points.back(), (Point3{0.1, 0.2, 0.3}));
  EXPECT_EQ(mesh.triangles, (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {3, 1, 2}}));
  EXPECT_EQ(mesh.delta, (std::vector<float>{60.5F, 70}));
  EXPECT_EQ(mesh.source, (std::vector<std::uint8_t>{0, 1}));
  EXPECT_EQ(mesh.global_ids, (std::vector<std::uint64_t>{5, 7, 6, 9}));
}

TEST_F(Chunk, JoinsItsPieces) {
  const VtpMesh mesh = read(piece("0 1 2 3 1 2", "3 6") + piece("0 1 2 3 1 2", "3 6"));
  EXPECT_EQ(mesh.points.size(), 8U);
  EXPECT_EQ(mesh.triangles.back(), (std::array<std::uint32_t, 3>{7, 5, 6}));
  EXPECT_TRUE(mesh.delta.empty());
}

TEST_F(Chunk, WithWrongCornersIsRefused) {
  EXPECT_THROW(read(piece("0 1 2 3 1 4", "3 6")), InputError);
  EXPECT_THROW(read(piece("0 1 2 3 1 -1", "3 6")), InputError);
  EXPECT_THROW(read(piece("0 1 2 3 1 2", "4 6")), InputError);
  EXPECT_THROW(read(piece("0 1 2 3", "3 4")), InputError);
  EXPECT_THROW(read(piece("0 1 2 3 1 2", "3")), InputError);
  EXPECT_THROW(read(piece("0 1 2 3 1 2", "3 6",
                          "<CellData><DataArray type=\"Float32\" Name=\"Delta\">1</DataArray>"
                          "</CellData>")),
               InputError);
}

TEST(Index, GivesItsPiecesBesideIt) {
  const TestFolder folder;
  put_bytes(folder / "a.pvtp",
            "<?xml version=\"1.0\"?><VTKFile type=\"PPolyData\"><PPolyData><PPoints/>"
            "<Piece Source=\"a/chunk_000000.vtp\"/><Piece Source=\"/b.vtp\"/></PPolyData>"
            "</VTKFile>");
  EXPECT_EQ(read_pvtp_index(folder / "a.pvtp"),
            (std::vector<std::string>{folder / "a/chunk_000000.vtp", "/b.vtp"}));
  put_bytes(folder / "b.pvtp", "<VTKFile type=\"PolyData\"></VTKFile>");
  EXPECT_THROW(read_pvtp_index(folder / "b.pvtp"), InputError);
  const Outcome as_points = read_path(folder / "a.pvtp", InputFormat::kAuto);
  EXPECT_NE(as_points.error.find("is an index"), std::string::npos) << as_points.error;
}

}  // namespace
}  // namespace stream_recon
