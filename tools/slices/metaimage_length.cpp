#include "tools/slices/metaimage_length.h"

#include <fmt/format.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "io/error.h"

namespace stream_recon {

void check_metaimage_length(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::uint64_t promised = 0;
  std::filesystem::path data;
  for (std::string line; data.empty() && std::getline(file, line);) {
    std::istringstream words(line);
    std::string key;
    std::string equals;
    words >> key >> equals;
    if (key == "CompressedDataSize") words >> promised;
    if (key == "ElementDataFile") words >> data;
  }
  const bool in_header_file = data == "LOCAL" || data == "Local" || data == "local";
  const std::uint64_t start = in_header_file && file ? static_cast<std::uint64_t>(file.tellg()) : 0;
  const auto data_path = in_header_file ? std::filesystem::path(path)
                                        : std::filesystem::path(path).parent_path() / data;
  std::error_code missing;  // which ITK reports
  const std::uint64_t length = std::filesystem::file_size(data_path, missing);
  if (missing || length >= start + promised) return;
  throw InputError(fmt::format("{}: ends at byte {} of {}; copy the file again", data_path.string(),
                               length, start + promised));
}

}  // namespace stream_recon
