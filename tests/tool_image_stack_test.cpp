// Slices that are pictures: their values, order, and everything that must be refused.
#include <gtest/gtest.h>

#include <random>

#include "tests/small_pictures.h"
#include "tests/volume_check.h"

namespace stream_recon {
namespace {

std::vector<double> values_of(const SmallPicture& picture) {
  return {picture.pixels.begin(), picture.pixels.end()};
}

void expect_says(const std::string& message, const std::string& part) {
  EXPECT_NE(message.find(part), std::string::npos) << "'" << message << "' lacks '" << part << "'";
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

class ImageStack : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return folder_ / name; }
  std::string refused_folder() const { return refusal(folder_.path()); }

  std::vector<double> read(const std::string& name) const {
    return voxels_of(*open_volume(request_of({path(name)})));
  }
  /// A picture of one value in all pixels.
  void write_flat(const std::string& name, unsigned value, std::size_t width = 5) const {
    SmallPicture picture{width, 4, 8, std::vector<unsigned>(width * 4, value)};
    write_small_png(path(name), picture);
  }
  /// The value of each slice of the folder.
  std::vector<double> slices(const VolumeRequest& request) const {
    const auto volume = open_volume(request);
    std::vector<double> first;
    std::vector<double> slice(20);
    for (std::size_t k = 0; k < volume->geometry().size[2]; ++k) {
      volume->read_slice(k, slice);
      first.push_back(slice[7]);
    }
    return first;
  }

  TestFolder folder_;
};

TEST_F(ImageStack, PngValuesAreThoseStored) {
  for (const unsigned bits : {1U, 2U, 4U, 8U, 16U}) {
    for (const bool interlaced : {false, true}) {
      SCOPED_TRACE(std::to_string(bits) + " bits, interlaced " + std::to_string(interlaced));
      const SmallPicture picture = make_picture(13, 9, bits, bits);
      PngStyle style;
      style.interlaced = interlaced;
      write_small_png(path("a.png"), picture, style);
      EXPECT_EQ(read("a.png"), values_of(picture));
    }
  }
}

TEST_F(ImageStack, AGreyPaletteGivesGreysAndAnotherIsRefused) {
  const SmallPicture picture{2, 2, 2, {0, 3, 2, 1}};
  PngStyle style;
  style.color = PNG_COLOR_TYPE_PALETTE;
  style.palette = {{7, 7, 7}, {90, 90, 90}, {100, 100, 100}, {200, 200, 200}};
  write_small_png(path("a.png"), picture, style);
  EXPECT_EQ(read("a.png"), (std::vector<double>{7, 200, 100, 90}));
  style.palette[2].blue = 99;
  write_small_png(path("a.png"), picture, style);
  expect_says(refusal(path("a.png")), "a.png: a colour image");
}

TEST_F(ImageStack, ColorIsRefused) {
  const SmallPicture picture = make_picture(6, 5, 8, 1);
  for (const int color : {PNG_COLOR_TYPE_RGB, PNG_COLOR_TYPE_RGBA, PNG_COLOR_TYPE_GRAY_ALPHA}) {
    PngStyle style;
    style.color = color;
    write_small_png(path("a.png"), picture, style);
    expect_says(refusal(path("a.png")), "a.png: a colour image; extract one channel");
  }
  write_small_jpeg(path("b.jpg"), picture, 3);
  expect_says(refusal(path("b.jpg")), "b.jpg: a colour image");
  write_small_bmp(path("c.bmp"), picture, false, true);
  expect_says(refusal(path("c.bmp")), "c.bmp: a colour image");
  TiffStyle style;
  style.photometric = PHOTOMETRIC_PALETTE;
  std::vector<std::uint16_t> ramp(256, 9);
  TIFF* tiff = TIFFOpen(path("d.tif").c_str(), "w");
  TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 8);
  TIFFSetField(tiff, TIFFTAG_COLORMAP, ramp.data(), ramp.data(), ramp.data());
  put_tiff_page(tiff, picture, style);
  TIFFClose(tiff);
  expect_says(refusal(path("d.tif")), "d.tif: a colour image");
}

TEST_F(ImageStack, BmpValuesAreTheGreysOfThePalette) {
  for (const bool from_top : {false, true}) {
    const SmallPicture grey = make_picture(7, 5, 8, 3);
    write_small_bmp(path("a.bmp"), grey, from_top);
    EXPECT_EQ(read("a.bmp"), values_of(grey));
    const SmallPicture mask = make_picture(37, 5, 1, 4);
    write_small_bmp(path("a.bmp"), mask, from_top);
    EXPECT_EQ(read("a.bmp"), values_of(mask));
  }
}

TEST_F(ImageStack, JpegValuesAreThoseOfTheFileWithinItsLoss) {
  SmallPicture ramp{32, 16, 8, {}};
  for (unsigned n = 0; n < 32 * 16; ++n) ramp.pixels.push_back(n % 32 * 8);
  write_small_jpeg(path("a.jpg"), ramp);
  const auto voxels = read("a.jpg");
  for (std::size_t n = 0; n < voxels.size(); ++n) EXPECT_NEAR(voxels[n], ramp.pixels[n], 3);
}

std::vector<TiffStyle> tiff_styles() {
  std::vector<TiffStyle> all;
  for (const char* mode : {"wl", "wb", "w8"}) {
    for (const std::uint16_t compression :
         {COMPRESSION_NONE, COMPRESSION_LZW, COMPRESSION_PACKBITS, COMPRESSION_ADOBE_DEFLATE}) {
      TiffStyle style;
      style.mode = mode;
      style.compression = compression;
      all.push_back(style);
      style.tiled = true;
      all.push_back(style);
    }
  }
  return all;
}

TEST_F(ImageStack, PagesOfEveryKindOfTiffAreSlices) {
  for (const TiffStyle& style : tiff_styles()) {
    for (const unsigned bits : {1U, 4U, 8U, 16U}) {
      SCOPED_TRACE(std::string(style.mode) + ", compression " + std::to_string(style.compression) +
                   ", bits " + std::to_string(bits) + (style.tiled ? ", tiled" : ""));
      const std::vector<SmallPicture> pages{make_picture(21, 19, bits, 1),
                                            make_picture(21, 19, bits, 2),
                                            make_picture(21, 19, bits, 3)};
      write_small_tiff(path("a.tif"), pages, style);
      const auto volume = open_volume(request_of({path("a.tif")}));
      EXPECT_EQ(volume->geometry().size, (std::array<std::size_t, 3>{21, 19, 3}));
      std::vector<double> slice(21 * 19);
      for (const std::size_t k : {0, 1, 2, 0, 2, 1}) {
        volume->read_slice(k, slice);
        EXPECT_EQ(slice, values_of(pages[k])) << "page " << k;
      }
    }
  }
}

TEST_F(ImageStack, WhereZeroIsWhiteTiffValuesAreTurnedRound) {
  const SmallPicture picture = make_picture(9, 8, 8, 5);
  TiffStyle style;
  style.photometric = PHOTOMETRIC_MINISWHITE;
  write_small_tiff(path("a.tif"), {picture}, style);
  const auto voxels = read("a.tif");
  for (std::size_t n = 0; n < voxels.size(); ++n) EXPECT_EQ(voxels[n], 255 - picture.pixels[n]);
}

TEST_F(ImageStack, PagesThatImageJDoesNotDescribeAreRead) {
  const SmallPicture first = make_picture(6, 5, 16, 1);
  const SmallPicture second = make_picture(6, 5, 16, 2);
  const auto number = [](std::size_t value, int size) {
    std::string text;
    while (size-- > 0) text += static_cast<char>(value >> 8 * size);
    return text;
  };
  const std::string description = "ImageJ=1.53t\nimages=2\nslices=2\n";
  const std::size_t start = 8 + 2 + 9 * 12 + 4 + description.size() + 1;
  std::string bytes = std::string("MM\0*", 4) + number(8, 4) + number(9, 2);
  for (const auto& [tag, value] : std::vector<std::pair<std::size_t, std::size_t>>{{256, 6},
                                                                                   {257, 5},
                                                                                   {258, 16},
                                                                                   {259, 1},
                                                                                   {262, 1},
                                                                                   {270, 122},
                                                                                   {273, start},
                                                                                   {277, 1},
                                                                                   {279, 60}}) {
    const std::size_t count = tag == 270 ? description.size() + 1 : 1;
    const bool is_short = tag == 258 || tag == 259 || tag == 262 || tag == 277;
    bytes += number(tag, 2) +
             number(tag == 270 ? 2
                    : is_short ? 3
                               : 4,
                    2) +
             number(count, 4) + (is_short ? number(value, 2) + number(0, 2) : number(value, 4));
  }
  bytes += number(0, 4) + description + std::string(1, '\0');
  for (const SmallPicture* page : {&first, &second})
    for (std::size_t y = 0; y < 5; ++y) bytes += packed_row(*page, y, true);
  put_bytes(path("a.tif"), bytes);
  auto expected = values_of(first);
  for (const double v : values_of(second)) expected.push_back(v);
  EXPECT_EQ(read("a.tif"), expected);
  put_bytes(path("a.tif"), bytes.substr(0, bytes.size() - 1));
  expect_says(refusal(path("a.tif")), "instead of");
}

TEST_F(ImageStack, AFolderIsSortedByTheNumbersInTheNames) {
  for (const unsigned n : {1U, 2U, 9U, 10U, 11U, 3U, 8U, 7U, 6U, 5U, 4U})
    write_flat("slice_" + std::to_string(n) + ".png", n);
  put_bytes(path("README"), "text");
  put_bytes(path("notes.txt"), "text");
  put_bytes(path(".slice_12.png"), "hidden");
  std::filesystem::create_directory(path("slice_12.png.d"));
  EXPECT_EQ(slices(request_of({folder_.path()})),
            (std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}));
}

TEST_F(ImageStack, FilesGivenOneByOneKeepTheirOrder) {
  for (const unsigned n : {1U, 2U, 3U}) write_flat(std::to_string(n) + ".png", n);
  EXPECT_EQ(slices(request_of({path("3.png"), path("1.png"), path("2.png"), path("1.png")})),
            (std::vector<double>{3, 1, 2, 1}));
}

TEST_F(ImageStack, NumbersInEvenStepsAreARow) {
  for (const unsigned n : {1U, 6U, 11U, 16U}) write_flat(std::to_string(n) + "z.png", n);
  EXPECT_EQ(slices(request_of({folder_.path()})), (std::vector<double>{1, 6, 11, 16}));
}

TEST_F(ImageStack, AMissingNumberIsNamed) {
  for (const unsigned n : {8U, 9U, 10U, 12U, 13U})
    write_flat((n < 10 ? "s_00" : "s_0") + std::to_string(n) + ".png", n);
  expect_says(refused_folder(), "s_011.png is missing between s_010.png and s_012.png");
}

TEST_F(ImageStack, OneOfTwoMissingIsNamed) {
  write_flat("1.png", 1);
  write_flat("3.png", 3);
  expect_says(refused_folder(), "2.png is missing between 1.png and 3.png");
}

TEST_F(ImageStack, ANumberThatStandsTwiceIsRefused) {
  for (const char* name : {"s1.png", "s2.png", "s02.png", "s3.png"}) write_flat(name, 1);
  expect_says(refused_folder(), "same number");
}

TEST_F(ImageStack, AMixOfKindsIsRefused) {
  write_flat("1.png", 1);
  write_small_bmp(path("2.bmp"), make_picture(5, 4, 8, 1));
  expect_says(refused_folder(), "1.png (PNG) and 2.bmp (BMP) in one folder");
  expect_says(refusal(request_of({path("1.png"), path("2.bmp")})), "2.bmp: not a PNG");
}

TEST_F(ImageStack, ASliceOfAnotherSizeIsRefusedWithBothSizes) {
  write_flat("1.png", 1);
  write_flat("2.png", 1, 6);
  expect_says(refused_folder(), "2.png: 6 x 4 of 8-bit unsigned, but ");
  expect_says(refused_folder(), "1.png is 5 x 4 of 8-bit unsigned");
}

TEST_F(ImageStack, ASliceOfAnotherTypeIsRefusedWithBothTypes) {
  write_flat("1.png", 1);
  write_small_png(path("2.png"), make_picture(5, 4, 16, 1));
  expect_says(refused_folder(), "2.png: 5 x 4 of 16-bit unsigned, but ");
}

TEST_F(ImageStack, APageOfAnotherSizeIsRefusedWithBothSizes) {
  write_small_tiff(path("a.tif"), {make_picture(5, 4, 8, 1), make_picture(5, 3, 8, 1)});
  expect_says(refusal(path("a.tif")), "page 2 is 5 x 3 of 8-bit unsigned, but page 1 5 x 4");
}

TEST_F(ImageStack, SeveralFilesOfPagesAreRefused) {
  const auto page = make_picture(5, 4, 8, 1);
  write_small_tiff(path("heart.tif"), {page, page});
  write_small_tiff(path("liver.tif"), {page, page});
  expect_says(refused_folder(), "heart.tif: one of several files, but itself has 2 pages");
}

TEST_F(ImageStack, AFolderWithoutSlicesIsRefused) {
  put_bytes(path("README"), "nothing");
  expect_says(refused_folder(), "no PNG, TIFF, JPEG, BMP or DICOM slices in this folder");
}

TEST_F(ImageStack, SpacingIsUnknownUnlessGiven) {
  const auto picture = make_picture(5, 4, 8, 1);
  write_small_png(path("a.png"), picture);
  write_small_tiff(path("a.tif"), {picture});
  write_small_jpeg(path("a.jpg"), picture);
  write_small_bmp(path("a.bmp"), picture);
  for (const char* name : {"a.png", "a.tif", "a.jpg", "a.bmp"}) {
    SCOPED_TRACE(name);
    VolumeRequest request = request_of({path(name)}, true);
    expect_says(refusal(request),
                "the distance of its voxels is not known; give it with --spacing");
    request.needs_spacing = false;
    EXPECT_FALSE(open_volume(request)->geometry().has_spacing);
    request.needs_spacing = true;
    request.spacing = {0.5, 0.25, 3};
    const auto volume = open_volume(request);
    EXPECT_TRUE(volume->geometry().has_spacing);
    EXPECT_EQ(volume->geometry().position(2, 4, 1), (Point3{1, 1, 3}));
  }
}

// Whatever is cut off, the picture is refused. Of a TIFF file only bytes that nothing refers to
// could be missing, and libtiff writes none.
TEST_F(ImageStack, EveryTruncationIsRefusedWithOneLine) {
  const auto page = make_picture(11, 7, 8, 1);
  write_small_png(path("a.png"), page);
  PngStyle interlaced;
  interlaced.interlaced = true;
  write_small_png(path("b.png"), page, interlaced);
  write_small_jpeg(path("a.jpg"), page);
  write_small_bmp(path("a.bmp"), page);
  write_small_tiff(path("a.tif"), {page, make_picture(11, 7, 8, 2)});
  TiffStyle packed;
  packed.compression = COMPRESSION_LZW;
  packed.mode = "w8";
  write_small_tiff(path("b.tif"), {page, make_picture(11, 7, 8, 2)}, packed);
  for (const char* name : {"a.png", "b.png", "a.jpg", "a.bmp", "a.tif", "b.tif"}) {
    const std::string whole = file_bytes(path(name));
    ASSERT_EQ(refusal(path(name)), "");
    for (std::size_t left = 0; left < whole.size(); ++left) {
      put_bytes(path(name), whole.substr(0, left));
      const std::string message = refusal(path(name));
      ASSERT_NE(message, "") << name << " cut to " << left << " of " << whole.size();
      ASSERT_EQ(message.find('\n'), std::string::npos) << message;
    }
  }
}

TEST_F(ImageStack, ACutSliceOfAFolderIsRefusedByName) {
  std::mt19937 random(3);
  for (const unsigned n : {1U, 2U, 3U, 4U}) write_flat(std::to_string(n) + ".png", n);
  const std::string whole = file_bytes(path("4.png"));
  for (std::size_t round = 0; round < 20; ++round) {
    const std::size_t left = round < 9 ? round : random() % whole.size();
    put_bytes(path("4.png"), whole.substr(0, left));
    expect_says(refused_folder(), "4.png: ");
  }
}

// No byte that is changed makes the reader do anything but read or refuse.
TEST_F(ImageStack, DamageIsReadOrRefused) {
  std::mt19937 random(4);
  const auto page = make_picture(11, 7, 8, 1);
  write_small_png(path("a.png"), page);
  write_small_jpeg(path("a.jpg"), page);
  write_small_bmp(path("a.bmp"), page);
  TiffStyle packed;
  packed.compression = COMPRESSION_LZW;
  write_small_tiff(path("a.tif"), {page, make_picture(11, 7, 8, 2)}, packed);
  for (const char* name : {"a.png", "a.jpg", "a.bmp", "a.tif"}) {
    const std::string whole = file_bytes(path(name));
    for (int round = 0; round < 300; ++round) {
      std::string bytes = whole;
      for (int n = 0; n < 3; ++n) bytes[random() % bytes.size()] = static_cast<char>(random());
      put_bytes(path(name), bytes);
      const std::string message = refusal(path(name));
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    }
  }
}

}  // namespace
}  // namespace stream_recon
