// However long a stack is, reading it takes a few slices' memory.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <tiffio.h>
#include <unistd.h>
#include <zlib.h>

#include <cstdint>
#include <fstream>

#include "tests/small_pictures.h"
#include "tests/volume_check.h"

namespace stream_recon {
namespace {

constexpr std::size_t kSide = 256;
constexpr int kLong = 2000;
constexpr long kAllowedKib = 64 * 1024;

/// The slice that all stacks are made of.
const SmallPicture& picture() {
  static const SmallPicture kPicture = [] {
    SmallPicture p{kSide, kSide, 8, {}};
    for (std::size_t n = 0; n < kSide * kSide; ++n)
      p.pixels.push_back(static_cast<unsigned>(n / kSide + n % kSide) / 2);
    return p;
  }();
  return kPicture;
}

std::string slice_bytes() {
  std::string bytes;
  for (const unsigned v : picture().pixels) bytes += static_cast<char>(v);
  return bytes;
}

void write_packed(const std::string& path, const char* mode, const std::string& head, int slices) {
  const gzFile file = gzopen(path.c_str(), mode);
  gzwrite(file, head.data(), static_cast<unsigned>(head.size()));
  const std::string slice = slice_bytes();
  for (int k = 0; k < slices; ++k) gzwrite(file, slice.data(), static_cast<unsigned>(slice.size()));
  gzclose(file);
}

std::string write_nifti(const TestFolder& folder, int slices) {
  std::string header(352, '\0');
  const auto put = [&](std::size_t at, const auto& value) {
    std::memcpy(&header[at], &value, sizeof value);
  };
  put(0, std::int32_t{348});
  const std::int16_t sizes[] = {3, kSide, kSide, static_cast<std::int16_t>(slices), 1, 1, 1, 1};
  put(40, sizes);
  put(70, std::int16_t{2});
  put(72, std::int16_t{8});
  const float spacings[] = {1, 1, 1, 2, 1, 1, 1, 1};
  put(76, spacings);
  put(108, 352.F);
  header.replace(344, 3, "n+1");
  write_packed(folder / "a.nii.gz", "wb1", header, slices);
  return folder / "a.nii.gz";
}

std::string write_nrrd(const TestFolder& folder, int slices) {
  put_bytes(folder / "a.nhdr", "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 256 256 " +
                                   std::to_string(slices) +
                                   "\nspacings: 1 1 2\nencoding: gzip\ndata file: a.gz\n");
  write_packed(folder / "a.gz", "wb1", "", slices);
  return folder / "a.nhdr";
}

std::string write_metaimage(const TestFolder& folder, int slices) {
  put_bytes(folder / "a.mhd",
            "ObjectType = Image\nNDims = 3\nDimSize = 256 256 " + std::to_string(slices) +
                "\nElementType = MET_UCHAR\nElementSpacing = 1 1 2\nBinaryData = True\n"
                "CompressedData = True\nElementDataFile = a.zraw\n");
  write_packed(folder / "a.zraw", "wb1", "", slices);
  return folder / "a.mhd";
}

std::string write_pngs(const TestFolder& folder, int slices) {
  write_small_png(folder / "slice_0.png", picture());
  for (int k = 1; k < slices; ++k)
    std::filesystem::create_hard_link(folder / "slice_0.png",
                                      folder / ("slice_" + std::to_string(k) + ".png"));
  return folder.path();
}

std::string write_tiff(const TestFolder& folder, int slices) {
  TiffStyle style;
  style.compression = COMPRESSION_PACKBITS;
  TIFF* tiff = TIFFOpen((folder / "a.tif").c_str(), "w");
  for (int k = 0; k < slices; ++k) put_tiff_page(tiff, picture(), style);
  TIFFClose(tiff);
  return folder / "a.tif";
}

/// The peak of the resident set of this process while it reads the volume, in KiB; -1 if it cannot.
long peak_here(const std::string& path) {
  std::ofstream("/proc/self/clear_refs") << "5";  // what the parent held before does not count
  const auto volume = open_volume(request_of({path}));
  std::vector<double> slice(kSide * kSide);
  double sum = 0;
  for (std::size_t k = 0; k < volume->geometry().size[2]; ++k) {
    volume->read_slice(k, slice);
    sum += slice[kSide * kSide - 1];
  }
  if (sum != 255.0 * static_cast<double>(volume->geometry().size[2])) return -1;
  long peak = -1;
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (word == "VmHWM:") status >> peak;
  return peak;
}

/// The same in a child.
long peak_of_reading(const std::string& path) {
  int ends[2];
  if (pipe(ends) != 0) return -1;
  const pid_t child = fork();
  if (child == 0) {
    long peak = -1;
    try {
      peak = peak_here(path);
    } catch (const std::exception& e) {
      std::cerr << e.what() << "\n";
    }
    _exit(write(ends[1], &peak, sizeof peak) == sizeof peak ? 0 : 1);
  }
  close(ends[1]);
  long peak = -1;
  if (read(ends[0], &peak, sizeof peak) != sizeof peak) peak = -1;
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  return peak;
}

struct StackWriter {
  const char* name;
  std::string (*write)(const TestFolder&, int slices);
};

class SlicesMemory : public testing::TestWithParam<StackWriter> {};

TEST_P(SlicesMemory, ALongStackTakesAsMuchAsAShortOne) {
  const TestFolder short_folder;
  const TestFolder long_folder;
  const long least = peak_of_reading(GetParam().write(short_folder, 2));
  const long most = peak_of_reading(GetParam().write(long_folder, kLong));
  ASSERT_GT(least, 0);
  ASSERT_GT(most, 0);
  EXPECT_LE(most, least + kAllowedKib);
  RecordProperty("kib_of_two_slices", std::to_string(least));
  RecordProperty("kib_of_all", std::to_string(most));
}

INSTANTIATE_TEST_SUITE_P(All, SlicesMemory,
                         testing::Values(StackWriter{"nifti", write_nifti},
                                         StackWriter{"nrrd", write_nrrd},
                                         StackWriter{"metaimage", write_metaimage},
                                         StackWriter{"png", write_pngs},
                                         StackWriter{"tiff", write_tiff}),
                         [](const auto& stack) { return std::string(stack.param.name); });

}  // namespace
}  // namespace stream_recon
