// NIfTI, NRRD and MetaImage: the voxels, geometry and refusals of open_volume.
#include <gtest/gtest.h>
#include <itkImageRegionIteratorWithIndex.h>
#include <itkVector.h>

#include <cmath>
#include <random>

#include "tests/io_test_folder.h"
#include "tests/volume_check.h"
#include "tools/sampling/sampling.h"

namespace stream_recon {
namespace {

using Image = itk::Image<short, 3>;
constexpr double kRadius = 9.3;

class VolumeFile : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return folder_ / name; }

  void expect_as_itk(const std::string& name) const {
    SCOPED_TRACE(name);
    const auto image = read_with_itk(path(name));
    const auto volume = open_volume(request_of({path(name)}));
    const auto voxels = voxels_of(*volume);
    ASSERT_EQ(voxels.size(), image->GetLargestPossibleRegion().GetNumberOfPixels());
    for (std::size_t at = 0; at < voxels.size(); ++at)
      ASSERT_EQ(voxels[at], image->GetBufferPointer()[at]) << "voxel " << at;
    EXPECT_EQ(voxels_of(*volume), voxels) << "in a second scan";
  }

  TestFolder folder_;
};

// Voxels are 100 times the distance to a sphere, positive inside; axes are swapped and stretched.
Image::Pointer make_sphere() {
  const auto image = Image::New();
  image->SetRegions(Image::SizeType{{24, 30, 40}});
  image->Allocate();
  const double spacing[3] = {1, 0.75, 0.5};
  const double origin[3] = {-10, 20, 5};
  image->SetSpacing(spacing);
  image->SetOrigin(origin);
  Image::DirectionType direction;
  direction.Fill(0);
  direction(1, 0) = 1;
  direction(0, 1) = -1;
  direction(2, 2) = 1;
  image->SetDirection(direction);
  for (itk::ImageRegionIteratorWithIndex<Image> at(image, image->GetLargestPossibleRegion());
       !at.IsAtEnd(); ++at) {
    const auto& index = at.GetIndex();
    const double distance =
        std::hypot(index[0] - 11.5, (index[1] - 14.5) * 0.75, (index[2] - 19.5) * 0.5);
    at.Set(static_cast<short>(std::lround(100 * (kRadius - distance))));
  }
  return image;
}

// Edges with one positive end, counted by looking at every pair of neighbours.
std::size_t count_crossed_edges(const Image& image) {
  const auto region = image.GetLargestPossibleRegion();
  std::size_t count = 0;
  for (itk::ImageRegionConstIteratorWithIndex<Image> at(&image, region); !at.IsAtEnd(); ++at) {
    for (int axis = 0; axis < 3; ++axis) {
      Image::IndexType next = at.GetIndex();
      ++next[axis];
      if (region.IsInside(next) && (at.Get() > 0) != (image.GetPixel(next) > 0)) ++count;
    }
  }
  return count;
}

const std::vector<std::pair<std::string, bool>>& formats() {
  static const std::vector<std::pair<std::string, bool>> all{
      {"plain.nii", false},   {"packed.nii.gz", true}, {"pair.hdr", false},   {"plain.mha", false},
      {"packed.mha", true},   {"plain.mhd", false},    {"packed.mhd", true},  {"plain.nrrd", false},
      {"packed.nrrd", true},  {"plain.nhdr", false},   {"packed.nhdr", true}, {"plain.vtk", false},
      {"packed.img.gz", true}};
  return all;
}

bool keeps_directions(const std::string& name) {
  return name != "plain.vtk" && name != "pair.hdr" && name != "packed.img.gz";
}

/// The file that holds the voxels.
std::string data_name(const std::string& name) {
  const std::string stem = name.substr(0, name.rfind('.'));
  if (name == "plain.mhd" || name == "plain.nhdr") return stem + ".raw";
  if (name == "packed.mhd") return stem + ".zraw";
  if (name == "packed.nhdr") return stem + ".raw.gz";
  if (name == "pair.hdr") return stem + ".img";
  return name;
}

TEST_F(VolumeFile, EveryFormatGivesThePointsOfTheSphere) {
  const Image::Pointer image = make_sphere();
  Image::PointType center;
  itk::ContinuousIndex<double, 3> middle;
  middle[0] = 11.5;
  middle[1] = 14.5;
  middle[2] = 19.5;
  image->TransformContinuousIndexToPhysicalPoint(middle, center);
  for (const auto& [name, compressed] : formats()) {
    if (!keeps_directions(name)) continue;
    SCOPED_TRACE(name);
    write_image(path(name), image.GetPointer(), compressed);
    const auto volume = open_volume(request_of({path(name)}, true));
    std::size_t count = 0;
    SamplingOptions options;
    options.iso = 0.5;
    Sampling(*volume, options).run([&](const Point3& p) {
      ++count;
      const double distance = std::hypot(p.x - center[0], p.y - center[1], p.z - center[2]);
      EXPECT_NEAR(distance, kRadius, 0.03);
    });
    EXPECT_EQ(count, count_crossed_edges(*image));
  }
}

TEST_F(VolumeFile, GeometryIsTheOneOfItk) {
  const Image::Pointer image = make_sphere();
  for (const char* name : {"a.nii.gz", "a.nrrd", "a.mha"}) {
    SCOPED_TRACE(name);
    write_image(path(name), image.GetPointer(), true);
    const auto volume = open_volume(request_of({path(name)}, true));
    EXPECT_TRUE(volume->geometry().has_spacing);
    for (const Image::IndexType index :
         {Image::IndexType{{0, 0, 0}}, Image::IndexType{{3, 7, 11}}}) {
      Image::PointType expected;
      image->TransformIndexToPhysicalPoint(index, expected);
      const Point3 p = volume->geometry().position(index[0], index[1], index[2]);
      EXPECT_NEAR(p.x, expected[0], 1e-5);
      EXPECT_NEAR(p.y, expected[1], 1e-5);
      EXPECT_NEAR(p.z, expected[2], 1e-5);
    }
  }
}

template <typename Voxel>
typename itk::Image<Voxel, 3>::Pointer make_noise() {
  const auto image = itk::Image<Voxel, 3>::New();
  image->SetRegions(itk::Size<3>{{7, 5, 6}});
  image->Allocate();
  std::mt19937_64 random(7);
  for (std::size_t at = 0; at < 7 * 5 * 6; ++at) {
    const std::uint64_t bits = random();
    image->GetBufferPointer()[at] = std::is_floating_point_v<Voxel>
                                        ? static_cast<Voxel>(std::ldexp(bits, -50))
                                        : static_cast<Voxel>(bits);
  }
  return image;
}

template <typename Voxel>
void write_noise(const std::string& path, bool compressed) {
  write_image(path, make_noise<Voxel>().GetPointer(), compressed);
}

TEST_F(VolumeFile, EveryTypeOfEveryFormatIsReadAsByItk) {
  const std::vector<std::pair<std::string, void (*)(const std::string&, bool)>> types{
      {"u8", write_noise<unsigned char>},   {"i8", write_noise<signed char>},
      {"u16", write_noise<unsigned short>}, {"i16", write_noise<short>},
      {"u32", write_noise<unsigned int>},   {"i32", write_noise<int>},
      {"f32", write_noise<float>},          {"f64", write_noise<double>}};
  for (const auto& [type, write] : types) {
    for (const char* ending : {".nii", ".nii.gz", ".hdr", ".mha", ".mhd", ".nrrd", ".nhdr"}) {
      for (const bool compressed : {false, true}) {
        const std::string name = type + (compressed ? "_packed" : "_plain") + ending;
        write(path(name), compressed);
        expect_as_itk(name);
      }
    }
  }
}

template <typename Number>
void put_number(std::string& bytes, std::size_t at, Number value) {
  std::memcpy(&bytes[at], &value, sizeof value);
}

TEST_F(VolumeFile, NiftiSlopeAndInterceptAreAppliedAsByItk) {
  for (const auto& [type, write] :
       std::vector<std::pair<std::string, void (*)(const std::string&, bool)>>{
           {"i16", write_noise<short>},
           {"i32", write_noise<int>},
           {"f32", write_noise<float>},
           {"f64", write_noise<double>}}) {
    for (const auto& [slope, intercept] : {std::pair{0.37F, -1024.F}, {1.F, 12.5F}, {0.F, 0.F}}) {
      const std::string name = type + ".nii";
      write(path(name), false);
      std::string bytes = file_bytes(path(name));
      put_number(bytes, 112, slope);
      put_number(bytes, 116, intercept);
      put_bytes(path(name), bytes);
      expect_as_itk(name);
    }
  }
}

// The header's numbers and the voxels turned round.
TEST_F(VolumeFile, NiftiOfTheOtherByteOrderIsReadAsByItk) {
  write_noise<short>(path("swapped.nii"), false);
  std::string bytes = file_bytes(path("swapped.nii"));
  const auto swap = [&](std::size_t from, std::size_t size, std::size_t count) {
    for (std::size_t n = 0; n < count; ++n)
      std::reverse(&bytes[from + n * size], &bytes[from + (n + 1) * size]);
  };
  swap(0, 4, 1);
  swap(32, 4, 1);
  swap(36, 2, 1);
  swap(40, 2, 8);
  swap(56, 4, 3);
  swap(68, 2, 4);
  swap(76, 4, 11);
  swap(120, 2, 1);
  swap(124, 4, 6);
  swap(252, 2, 2);
  swap(256, 4, 18);
  swap(352, 2, (bytes.size() - 352) / 2);
  put_bytes(path("swapped.nii"), bytes);
  expect_as_itk("swapped.nii");
}

constexpr const char* kNrrd =
    "NRRD0004\ntype: short\ndimension: 3\nsizes: 3 2 4\nspacings: 1 2 3\nendian: big\n";

TEST_F(VolumeFile, NrrdVariantsAreReadAsByItk) {
  std::string voxels(48, '\0');
  for (std::size_t at = 0; at < voxels.size(); ++at) voxels[at] = static_cast<char>(at * 37);
  put_bytes(path("all.raw"), voxels);
  put_bytes(path("padded.raw"), "12345" + voxels);
  std::string list;
  for (int k = 0; k < 4; ++k) {
    put_bytes(path("s" + std::to_string(k + 8) + ".raw"), voxels.substr(12 * k, 12));
    list += "s" + std::to_string(k + 8) + ".raw\n";
  }
  put_bytes(path("h0.raw"), voxels.substr(0, 24));
  put_bytes(path("h1.raw"), voxels.substr(24));
  const std::string head = std::string(kNrrd) + "encoding: raw\n";
  put_bytes(path("one.nhdr"), head + "data file: all.raw\n");
  put_bytes(path("crlf.nhdr"),
            "NRRD0004\r\n# a: remark\r\nType: int16\r\ndimension: 3\r\n"
            "sizes: 3 2 4\r\nendian: little\r\nencoding: raw\r\n"
            "datafile: all.raw\r\n");
  put_bytes(path("skip.nhdr"), head + "byte skip: 5\ndata file: padded.raw\n");
  put_bytes(path("end.nhdr"), head + "byteskip: -1\ndata file: padded.raw\n");
  put_bytes(path("pattern.nhdr"), head + "data file: s%d.raw 8 11 1\n");
  put_bytes(path("list.nhdr"), head + "data file: LIST\n" + list);
  put_bytes(path("halves.nhdr"), head + "data file: h%01d.raw 0 1 1 3\n");
  put_bytes(path("attached.nrrd"), head + "key:=value\n\n" + voxels);
  put_bytes(
      path("text.nrrd"), std::string(kNrrd) + "encoding: ascii\n\n" + [] {
        std::string text;
        for (int v = 0; v < 24; ++v) text += std::to_string(v * v) + "\n";
        return text;
      }());
  for (const char* name : {"one.nhdr", "crlf.nhdr", "skip.nhdr", "end.nhdr", "pattern.nhdr",
                           "list.nhdr", "halves.nhdr", "attached.nrrd", "text.nrrd"})
    expect_as_itk(name);
}

TEST_F(VolumeFile, MetaImageVariantsAreReadAsByItk) {
  std::string voxels(48, '\0');
  for (std::size_t at = 0; at < voxels.size(); ++at) voxels[at] = static_cast<char>(at * 37);
  put_bytes(path("all.raw"), voxels);
  put_bytes(path("padded.raw"), "12345" + voxels);
  std::string list;
  for (int k = 0; k < 4; ++k) {
    put_bytes(path("s" + std::to_string(k + 8) + ".raw"), voxels.substr(12 * k, 12));
    list += "s" + std::to_string(k + 8) + ".raw\n";
  }
  const std::string head =
      "ObjectType = Image\nNDims = 3\nDimSize = 3 2 4\nElementType = MET_SHORT\n"
      "ElementSpacing = 1 2 3\nBinaryData = True\nBinaryDataByteOrderMSB = True\n";
  put_bytes(path("one.mhd"), head + "ElementDataFile = all.raw\n");
  put_bytes(path("skip.mhd"), head + "HeaderSize = 5\nElementDataFile = padded.raw\n");
  put_bytes(path("end.mhd"), head + "HeaderSize = -1\nElementDataFile = padded.raw\n");
  put_bytes(path("pattern.mhd"), head + "ElementDataFile = s%d.raw 8 11 1\n");
  put_bytes(path("list.mhd"), head + "ElementDataFile = LIST\n" + list);
  put_bytes(path("local.mha"), head + "ElementDataFile = LOCAL\n" + voxels);
  put_bytes(path("slope.mha"), head +
                                   "ElementToIntensityFunctionSlope = 2\n"
                                   "ElementToIntensityFunctionOffset = 7\n"
                                   "ElementDataFile = LOCAL\n" +
                                   voxels);
  for (const char* name :
       {"one.mhd", "skip.mhd", "end.mhd", "pattern.mhd", "list.mhd", "local.mha", "slope.mha"})
    expect_as_itk(name);
}

void expect_one_line(const std::string& message) {
  EXPECT_FALSE(message.empty());
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

// The file with the voxels is cut; one byte less than all of them is enough.
TEST_F(VolumeFile, EveryTruncationIsRefusedWithOneLine) {
  std::mt19937 random(11);
  for (const auto& [name, compressed] : formats()) {
    write_image(path(name), make_sphere().GetPointer(), compressed);
    const std::string data = path(data_name(name));
    const std::string whole = file_bytes(data);
    const std::size_t size = whole.size();
    std::vector<std::size_t> lengths{size - 1, size - 8, size / 2, 1000, 351, 100, 1, 0};
    for (int n = 0; n < 6; ++n) lengths.push_back(random() % size);
    for (const std::size_t left : lengths) {
      SCOPED_TRACE(name + " cut to " + std::to_string(left) + " of " + std::to_string(size));
      put_bytes(data, whole.substr(0, left));
      expect_one_line(refusal(path(name)));
    }
  }
}

TEST_F(VolumeFile, TinyFilesAreRefusedCutAtEveryByte) {
  const auto image = itk::Image<short, 3>::New();
  image->SetRegions(itk::Size<3>{{2, 3, 2}});
  image->Allocate(true);
  for (const auto& [name, compressed] : formats()) {
    write_image(path(name), image.GetPointer(), compressed);
    const std::string data = path(data_name(name));
    const std::string whole = file_bytes(data);
    for (std::size_t left = 0; left < whole.size(); ++left) {
      SCOPED_TRACE(name + " cut to " + std::to_string(left) + " of " +
                   std::to_string(whole.size()));
      put_bytes(data, whole.substr(0, left));
      expect_one_line(refusal(path(name)));
    }
  }
}

TEST_F(VolumeFile, OneMissingOrShortDataFileIsRefusedByName) {
  const std::string head = std::string(kNrrd) + "encoding: raw\ndata file: s%d.raw 1 4 1\n";
  put_bytes(path("a.nhdr"), head);
  for (const char* name : {"s1.raw", "s2.raw", "s3.raw", "s4.raw"})
    put_bytes(path(name), std::string(12, 'x'));
  EXPECT_EQ(refusal(path("a.nhdr")), "");
  put_bytes(path("s3.raw"), "short");
  EXPECT_NE(refusal(path("a.nhdr")).find("s3.raw: 5 bytes instead of 12"), std::string::npos);
  std::filesystem::remove(path("s3.raw"));
  EXPECT_NE(refusal(path("a.nhdr")).find("s3.raw: no such file"), std::string::npos);
}

TEST_F(VolumeFile, DamagedPackedVoxelsAreRefused) {
  for (const char* name : {"a.nii.gz", "a.mha", "a.nrrd"}) {
    write_image(path(name), make_sphere().GetPointer(), true);
    std::string bytes = file_bytes(path(name));
    bytes[bytes.size() - 40] ^= 0x11;
    put_bytes(path(name), bytes);
    SCOPED_TRACE(name);
    expect_one_line(refusal(path(name)));
  }
}

TEST_F(VolumeFile, WhatIsNoScalarVolumeIsRefused) {
  EXPECT_NE(refusal(path("missing.nii")).find("no such file"), std::string::npos);
  put_bytes(path("text.nii"), "this is no volume");
  EXPECT_NE(refusal(path("text.nii")).find("not a volume"), std::string::npos);
  put_bytes(path("empty.nrrd"), "");
  EXPECT_NE(refusal(path("empty.nrrd")).find("not a volume"), std::string::npos);

  using Vectors = itk::Image<itk::Vector<float, 3>, 3>;
  const auto vectors = Vectors::New();
  vectors->SetRegions(Vectors::SizeType{{2, 2, 2}});
  vectors->Allocate(true);
  write_image(path("vectors.mha"), vectors.GetPointer(), false);
  EXPECT_NE(refusal(path("vectors.mha")).find("3 values a voxel"), std::string::npos);

  using Series = itk::Image<float, 4>;
  const auto series = Series::New();
  series->SetRegions(Series::SizeType{{2, 2, 2, 5}});
  series->Allocate(true);
  write_image(path("series.nii"), series.GetPointer(), false);
  EXPECT_NE(refusal(path("series.nii")).find("4 dimensions"), std::string::npos);
}

}  // namespace
}  // namespace stream_recon
