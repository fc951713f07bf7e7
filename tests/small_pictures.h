// Small grey pictures written in every format that slices come in.
#pragma once

#include <png.h>
#include <tiffio.h>

#include <cstdint>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include <jpeglib.h>

#include "tests/io_test_folder.h"

namespace stream_recon {

struct SmallPicture {
  std::size_t width = 0, height = 0;
  unsigned bits = 8;
  std::vector<unsigned> pixels;  ///< row by row

  unsigned at(std::size_t x, std::size_t y) const { return pixels[y * width + x]; }
};

inline SmallPicture make_picture(std::size_t width, std::size_t height, unsigned bits,
                                 unsigned seed) {
  SmallPicture picture{width, height, bits, {}};
  for (std::size_t n = 0; n < width * height; ++n) {
    seed = seed * 1664525 + 1013904223;
    picture.pixels.push_back(seed >> 8 & ((1U << bits) - 1));
  }
  return picture;
}

/// A row as it lies in PNG and TIFF: the first pixel highest, 16 bits in the given order.
inline std::string packed_row(const SmallPicture& picture, std::size_t y, bool big_endian) {
  std::string row((picture.width * picture.bits + 7) / 8, '\0');
  for (std::size_t x = 0; x < picture.width; ++x) {
    const unsigned v = picture.at(x, y);
    if (picture.bits == 16) {
      row[2 * x + (big_endian ? 0 : 1)] = static_cast<char>(v >> 8);
      row[2 * x + (big_endian ? 1 : 0)] = static_cast<char>(v);
    } else {
      const std::size_t bit = x * picture.bits;
      row[bit / 8] = static_cast<char>(row[bit / 8] | v << (8 - picture.bits - bit % 8));
    }
  }
  return row;
}

struct PngStyle {
  int color = PNG_COLOR_TYPE_GRAY;
  bool interlaced = false;
  std::vector<png_color> palette;
};

/// For colour types with several values a pixel, each value of the picture is repeated.
inline void write_small_png(const std::string& path, const SmallPicture& picture,
                            const PngStyle& style = {}) {
  std::FILE* file = std::fopen(path.c_str(), "wb");
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_init_io(png, file);
  png_set_IHDR(png, info, static_cast<png_uint_32>(picture.width),
               static_cast<png_uint_32>(picture.height), static_cast<int>(picture.bits),
               style.color, style.interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (!style.palette.empty())
    png_set_PLTE(png, info, style.palette.data(), static_cast<int>(style.palette.size()));
  png_set_pHYs(png, info, 11811, 11811, PNG_RESOLUTION_METER);  // 300 dpi, not to be believed
  png_write_info(png, info);
  const std::size_t samples = png_get_channels(png, info);
  std::vector<std::string> rows;
  std::vector<png_bytep> pointers;
  for (std::size_t y = 0; y < picture.height; ++y) {
    const std::string row = packed_row(picture, y, true);
    rows.emplace_back();
    for (const char byte : row) rows.back().append(samples, byte);
  }
  for (std::string& row : rows) pointers.push_back(reinterpret_cast<png_bytep>(row.data()));
  png_write_image(png, pointers.data());
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  std::fclose(file);
}

struct TiffStyle {
  const char* mode = "w";
  std::uint16_t compression = COMPRESSION_NONE;
  std::uint16_t photometric = PHOTOMETRIC_MINISBLACK;
  bool tiled = false;
  std::string description;
};

inline void put_tiff_page(TIFF* tiff, const SmallPicture& picture, const TiffStyle& style) {
  TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, static_cast<std::uint32_t>(picture.width));
  TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, static_cast<std::uint32_t>(picture.height));
  TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, picture.bits);
  TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
  TIFFSetField(tiff, TIFFTAG_COMPRESSION, style.compression);
  TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, style.photometric);
  TIFFSetField(tiff, TIFFTAG_XRESOLUTION, 300.0);  // not to be believed
  TIFFSetField(tiff, TIFFTAG_YRESOLUTION, 300.0);
  if (!style.description.empty())
    TIFFSetField(tiff, TIFFTAG_IMAGEDESCRIPTION, style.description.c_str());
  if (style.tiled) {
    TIFFSetField(tiff, TIFFTAG_TILEWIDTH, 16);
    TIFFSetField(tiff, TIFFTAG_TILELENGTH, 16);
    for (std::uint32_t y = 0; y < picture.height; y += 16) {
      for (std::uint32_t x = 0; x < picture.width; x += 16) {
        SmallPicture tile{16, 16, picture.bits, std::vector<unsigned>(256)};
        for (std::size_t n = 0; n < 256; ++n)
          if (x + n % 16 < picture.width && y + n / 16 < picture.height)
            tile.pixels[n] = picture.at(x + n % 16, y + n / 16);
        std::string bytes;
        for (std::size_t row = 0; row < 16; ++row) bytes += packed_row(tile, row, false);
        TIFFWriteTile(tiff, bytes.data(), x, y, 0, 0);
      }
    }
  } else {
    TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, 3);
    for (std::size_t y = 0; y < picture.height; ++y) {
      std::string row = packed_row(picture, y, false);
      TIFFWriteScanline(tiff, row.data(), static_cast<std::uint32_t>(y), 0);
    }
  }
  TIFFWriteDirectory(tiff);
}

inline void write_small_tiff(const std::string& path, const std::vector<SmallPicture>& pages,
                             const TiffStyle& style = {}) {
  TIFF* tiff = TIFFOpen(path.c_str(), style.mode);
  for (const SmallPicture& page : pages) put_tiff_page(tiff, page, style);
  TIFFClose(tiff);
}

inline void write_small_jpeg(const std::string& path, const SmallPicture& picture,
                             int components = 1) {
  std::FILE* file = std::fopen(path.c_str(), "wb");
  jpeg_compress_struct jpeg{};
  jpeg_error_mgr errors{};
  jpeg.err = jpeg_std_error(&errors);
  jpeg_create_compress(&jpeg);
  jpeg_stdio_dest(&jpeg, file);
  jpeg.image_width = static_cast<JDIMENSION>(picture.width);
  jpeg.image_height = static_cast<JDIMENSION>(picture.height);
  jpeg.input_components = components;
  jpeg.in_color_space = components == 1 ? JCS_GRAYSCALE : JCS_RGB;
  jpeg_set_defaults(&jpeg);
  jpeg_set_quality(&jpeg, 100, TRUE);
  jpeg_start_compress(&jpeg, TRUE);
  for (std::size_t y = 0; y < picture.height; ++y) {
    std::vector<JSAMPLE> row;
    for (std::size_t x = 0; x < picture.width; ++x)
      row.insert(row.end(), static_cast<std::size_t>(components),
                 static_cast<JSAMPLE>(picture.at(x, y)));
    JSAMPROW pointer = row.data();
    jpeg_write_scanlines(&jpeg, &pointer, 1);
  }
  jpeg_finish_compress(&jpeg);
  jpeg_destroy_compress(&jpeg);
  std::fclose(file);
}

/// A BMP with a palette of greys (or of reds), its rows from the bottom or from the top.
inline void write_small_bmp(const std::string& path, const SmallPicture& picture,
                            bool from_top = false, bool red = false) {
  const auto number = [](std::uint32_t v, int bytes) {
    std::string text;
    for (int n = 0; n < bytes; ++n) text += static_cast<char>(v >> 8 * n);
    return text;
  };
  const std::uint32_t colors = 1U << picture.bits;
  const std::uint32_t start = 54 + 4 * colors;
  std::string pixels;
  for (std::size_t n = 0; n < picture.height; ++n) {
    pixels += packed_row(picture, from_top ? n : picture.height - 1 - n, true);
    pixels.resize((pixels.size() + 3) / 4 * 4);
  }
  const auto height = static_cast<std::uint32_t>(picture.height);
  std::string bytes = "BM" + number(start + static_cast<std::uint32_t>(pixels.size()), 4) +
                      number(0, 4) + number(start, 4) + number(40, 4) +
                      number(static_cast<std::uint32_t>(picture.width), 4) +
                      number(from_top ? 0U - height : height, 4) + number(1, 2) +
                      number(picture.bits, 2) + number(0, 4) + number(0, 4) + number(11811, 4) +
                      number(11811, 4) + number(colors, 4) + number(0, 4);
  for (std::uint32_t n = 0; n < colors; ++n) {
    const std::uint32_t grey = n * 255 / (colors - 1);
    bytes += number(red ? 0 : grey, 1) + number(red ? 0 : grey, 1) + number(grey, 1) + number(0, 1);
  }
  put_bytes(path, bytes + pixels);
}

}  // namespace stream_recon
