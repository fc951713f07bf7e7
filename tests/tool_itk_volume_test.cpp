#include "tools/slices/itk_volume.h"

#include <gtest/gtest.h>
#include <itkImage.h>
#include <itkImageFileWriter.h>
#include <itkImageRegionConstIteratorWithIndex.h>
#include <itkImageRegionIteratorWithIndex.h>
#include <itkVector.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <vector>

#include "io/error.h"
#include "tests/io_test_folder.h"
#include "tools/slices/iso_points.h"

namespace stream_recon {
namespace {

using Image = itk::Image<short, 3>;
constexpr double kRadius = 9.3;

class ItkVolume : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return folder_ / name; }

  template <typename AnyImage>
  void write(const std::string& name, AnyImage* image, bool compressed) const {
    const auto writer = itk::ImageFileWriter<AnyImage>::New();
    writer->SetFileName(path(name));
    writer->SetInput(image);
    writer->SetUseCompression(compressed);
    writer->Update();
  }

  std::string refusal(const std::string& file) const {
    try {
      const auto volume = open_itk_volume(file);
      scan_iso_points(*volume, 0, [](const Point3&) {});
    } catch (const InputError& e) {
      return e.what();
    }
    return "";
  }

 private:
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
      {"plain.nii", false},  {"packed.nii.gz", true}, {"pair.hdr", false},  {"plain.mha", false},
      {"packed.mha", true},  {"plain.mhd", false},    {"packed.mhd", true}, {"plain.nrrd", false},
      {"packed.nrrd", true}, {"plain.nhdr", false},   {"plain.vtk", false}};
  return all;
}

TEST_F(ItkVolume, EveryFormatGivesThePointsOfTheSphere) {
  const Image::Pointer image = make_sphere();
  Image::PointType center;
  itk::ContinuousIndex<double, 3> middle;
  middle[0] = 11.5;
  middle[1] = 14.5;
  middle[2] = 19.5;
  image->TransformContinuousIndexToPhysicalPoint(middle, center);
  for (const auto& [name, compressed] : formats()) {
    if (name == "plain.vtk" || name == "pair.hdr") continue;  // these keep no direction
    SCOPED_TRACE(name);
    write(name, image.GetPointer(), compressed);
    const auto volume = open_itk_volume(path(name));
    std::size_t count = 0;
    scan_iso_points(*volume, 0.5, [&](const Point3& p) {
      ++count;
      const double distance = std::hypot(p.x - center[0], p.y - center[1], p.z - center[2]);
      EXPECT_NEAR(distance, kRadius, 0.03);
    });
    EXPECT_EQ(count, count_crossed_edges(*image));
  }
}

TEST_F(ItkVolume, GeometryIsTheOneOfItk) {
  const Image::Pointer image = make_sphere();
  for (const char* name : {"a.nii.gz", "a.nrrd", "a.mha"}) {
    SCOPED_TRACE(name);
    write(name, image.GetPointer(), true);
    const auto volume = open_itk_volume(path(name));
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

// The file with the voxels is cut; one byte less than all of them is enough. (ITK's NRRD
// reader does not ask for the end that gzip writes after the packed voxels.)
TEST_F(ItkVolume, EveryTruncationIsRefusedWithOneLine) {
  for (const auto& [name, compressed] : formats()) {
    write(name, make_sphere().GetPointer(), compressed);
    std::filesystem::path data = path(name);
    if (name == "plain.mhd" || name == "plain.nhdr") data.replace_extension(".raw");
    if (name == "packed.mhd") data.replace_extension(".zraw");
    if (name == "pair.hdr") data.replace_extension(".img");
    const auto size = std::filesystem::file_size(data);
    const std::uintmax_t last = name == "packed.nrrd" ? 32 : 1;
    for (const std::uintmax_t left : {size - last, size * 9 / 10, size / 2, size / 5}) {
      SCOPED_TRACE(name + " cut to " + std::to_string(left) + " of " + std::to_string(size));
      std::filesystem::resize_file(data, left);
      const std::string message = refusal(path(name));
      EXPECT_FALSE(message.empty());
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    }
  }
}

TEST_F(ItkVolume, WhatIsNoScalarVolumeIsRefused) {
  EXPECT_NE(refusal(path("missing.nii")).find("no such file"), std::string::npos);
  EXPECT_NE(refusal(testing::TempDir()).find("folder"), std::string::npos);
  std::ofstream(path("text.nii")) << "this is no volume";
  EXPECT_NE(refusal(path("text.nii")).find("not a volume"), std::string::npos);
  std::ofstream(path("empty.nrrd")).close();
  EXPECT_NE(refusal(path("empty.nrrd")).find("not a volume"), std::string::npos);

  using Vectors = itk::Image<itk::Vector<float, 3>, 3>;
  const auto vectors = Vectors::New();
  vectors->SetRegions(Vectors::SizeType{{2, 2, 2}});
  vectors->Allocate(true);
  write("vectors.mha", vectors.GetPointer(), false);
  EXPECT_NE(refusal(path("vectors.mha")).find("3 values a voxel"), std::string::npos);

  using Series = itk::Image<float, 4>;
  const auto series = Series::New();
  series->SetRegions(Series::SizeType{{2, 2, 2, 5}});
  series->Allocate(true);
  write("series.nii", series.GetPointer(), false);
  EXPECT_NE(refusal(path("series.nii")).find("4 dimensions"), std::string::npos);
}

}  // namespace
}  // namespace stream_recon
