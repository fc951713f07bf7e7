#include "io/scratch_directory.h"

#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <system_error>

#include "io/error.h"
#include "io/folder.h"

namespace stream_recon {
namespace {

TemporaryPath make_temporary_folder(const std::string& name) {
  const std::string path = temporary_name_beside(name);
  make_folder(path);
  return {path, TemporaryPath::Kind::kFolder};
}

}  // namespace

ScratchDirectory::ScratchDirectory(const ScratchOptions& options)
    : folder_(make_temporary_folder(options.parent + "/stream-recon")),
      meter_(std::make_shared<StorageMeter>(options.limit_bytes)) {}

std::string ScratchDirectory::path_of(const std::string& name) const {
  if (name.empty() || name.find('/') != std::string::npos) {
    throw std::invalid_argument("a scratch file's name must be a plain name, not '" + name + "'");
  }
  return folder_.path() + "/" + name;
}

File ScratchDirectory::create(const std::string& name) {
  return File::create(path_of(name), meter_);
}

File ScratchDirectory::open(const std::string& name) const {
  return File::open(path_of(name));
}

void ScratchDirectory::remove(const std::string& name) {
  const std::string path = path_of(name);
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(path, error);
  if (error) return;
  remove_file(path.c_str());
  meter_->release(bytes);
}

std::string default_scratch_parent(const std::string& output_path) {
  if (output_path != "-") return parent_folder(output_path);
  const char* folder = std::getenv("TMPDIR");  // NOLINT(concurrency-mt-unsafe): read only
  return folder != nullptr && *folder != '\0' ? folder : "/var/tmp";
}

}  // namespace stream_recon
