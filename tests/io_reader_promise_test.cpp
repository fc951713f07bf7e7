// A header may promise any number of points, pieces or bytes: memory follows the bytes that come.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <new>

#include "io/vtp_mesh_reader.h"
#include "io_reader_helpers.h"

namespace {

std::atomic<std::size_t> largest_allocation{0};

void* allocate(std::size_t size) {
  std::size_t seen = largest_allocation;
  while (size > seen && !largest_allocation.compare_exchange_weak(seen, size)) {
  }
  void* memory = std::malloc(size);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace

void* operator new(std::size_t size) {
  return allocate(size);
}
void* operator new[](std::size_t size) {
  return allocate(size);
}
// The library's sorts take their buffer by this one; the sanitizer wants all of one kind.
void* operator new(std::size_t size, const std::nothrow_t& /*tag*/) noexcept {
  return std::malloc(size);
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete[](void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace stream_recon {
namespace {

constexpr std::size_t kMostAtOnce = 1 << 20;

std::string little_endian(std::initializer_list<std::uint64_t> numbers) {
  std::string bytes;
  for (const std::uint64_t number : numbers) {
    for (int shift = 0; shift < 64; shift += 8) bytes += static_cast<char>(number >> shift);
  }
  return bytes;
}

class Promise : public ::testing::TestWithParam<std::string> {
 protected:
  void expect_refused(const std::string& bytes, InputFormat format) {
    largest_allocation = 0;
    const Outcome outcome = file_.read(bytes, format, 100);
    EXPECT_NE(outcome.error, "");
    EXPECT_LE(largest_allocation, kMostAtOnce) << outcome.error;
  }
  ByteFile file_;
};

TEST_P(Promise, OfPlyVerticesTakesNoMemory) {
  for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    expect_refused(std::string("ply\nformat ") + format + " 1.0\nelement vertex " + GetParam() +
                       "\nproperty float x\nproperty float y\nproperty float z\nend_header\n"
                       "1 2 3\n4 5 6\n",
                   InputFormat::kPly);
  }
}

TEST_P(Promise, OfPlyElementsBeforeTheVerticesTakesNoMemory) {
  for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    for (const char* property : {"double a", "list uchar int a"}) {
      expect_refused(std::string("ply\nformat ") + format + " 1.0\nelement other " + GetParam() +
                         "\nproperty " + property +
                         "\nelement vertex 1\nproperty float x\nproperty float y\nproperty float "
                         "z\nend_header\n1 2 3\n4 5 6\n",
                     InputFormat::kPly);
    }
  }
}

TEST_P(Promise, OfTextPointsTakesNoMemory) {
  expect_refused(GetParam() + "\n1 2 3\n4 5 6\n", InputFormat::kXyz);
}

TEST_P(Promise, OfLegacyPointsTakesNoMemory) {
  for (const char* encoding : {"ASCII", "BINARY"}) {
    expect_refused(std::string("# vtk DataFile Version 3.0\nx\n") + encoding +
                       "\nDATASET POLYDATA\nPOINTS " + GetParam() + " float\n1 2 3\n4 5 6\n",
                   InputFormat::kVtk);
    expect_refused(std::string("# vtk DataFile Version 3.0\nx\n") + encoding +
                       "\nDATASET POLYDATA\nFIELD f " + GetParam() + "\na 1 " + GetParam() +
                       " float\n1 2 3\n",
                   InputFormat::kVtk);
  }
}

TEST_P(Promise, OfXmlPointsTakesNoMemory) {
  const std::string head =
      "<VTKFile type=\"PolyData\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\"";
  const std::string piece = "><PolyData><Piece NumberOfPoints=\"" + GetParam() +
                            "\"><Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" ";
  const std::string end = "</Points></Piece></PolyData>";
  // A length or block header that keeps the promise, and nothing behind it.
  const std::uint64_t count = std::stoull(GetParam());
  const std::string plain = little_endian({12 * count});
  const std::string blocks = little_endian({count / 1024, std::uint64_t{12} * 1024, 0});
  expect_refused(head + piece + "format=\"ascii\">1 2 3</DataArray>" + end + "</VTKFile>",
                 InputFormat::kVtp);
  const std::string appended =
      "format=\"appended\" offset=\"0\"/>" + end + "<AppendedData encoding=\"raw\">_";
  expect_refused(head + piece + appended + plain + "12345", InputFormat::kVtp);
  const std::string rest = piece + appended + blocks + std::string(80, '\x10');
  for (const char* compressor : {"vtkZLibDataCompressor", "vtkLZ4DataCompressor"}) {
    std::string file = head;
    file.append(" compressor=\"").append(compressor).append("\"").append(rest);
    expect_refused(file, InputFormat::kVtp);
  }
}

TEST_P(Promise, OfTrianglesTakesNoMemory) {
  file_.put(
      "<VTKFile type=\"PolyData\" byte_order=\"LittleEndian\"><PolyData><Piece "
      "NumberOfPoints=\"" +
      GetParam() + "\" NumberOfPolys=\"" + GetParam() +
      "\"><Polys><DataArray type=\"Int64\" Name=\"offsets\">3 6</DataArray>"
      "</Polys></Piece></PolyData></VTKFile>");
  largest_allocation = 0;
  EXPECT_THROW(read_vtp_mesh(file_.path()), InputError);
  EXPECT_LE(largest_allocation, kMostAtOnce);
}

INSTANTIATE_TEST_SUITE_P(Counts, Promise,
                         ::testing::Values("300000000", "1000000000000000000",
                                           "18446744073709551615"));

}  // namespace
}  // namespace stream_recon
