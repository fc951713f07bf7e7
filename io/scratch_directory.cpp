#include "io/scratch_directory.h"

#include <cstdlib>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "io/error.h"
#include "io/folder.h"

namespace stream_recon {
namespace {

constexpr std::string_view kFolderName = "stream-recon";
constexpr int kAttempts = 3;

std::string new_path(const ScratchOptions& options) {
  return temporary_name_beside(options.parent + "/" + std::string(kFolderName));
}

}  // namespace

ScratchDirectory::ScratchDirectory(const ScratchOptions& options)
    : meter_(std::make_shared<StorageMeter>(options.limit_bytes)) {
  // Between making and locking another run may take the folder for a dead one's: then another.
  for (int attempt = 0; attempt < kAttempts && !lock_; ++attempt) {
    temporary_.reset();
    path_ = new_path(options);
    make_folder(path_);
    temporary_.emplace(path_, TemporaryPath::Kind::kFolder);
    lock_ = FolderLock::try_take(path_);
  }
}

ScratchDirectory::ScratchDirectory(AbandonedScratch abandoned, const ScratchOptions& options)
    : path_(new_path(options)),
      lock_(std::move(abandoned.lock)),
      is_kept_(true),
      meter_(std::make_shared<StorageMeter>(options.limit_bytes)) {
  rename_path(abandoned.path, path_);
  for (const std::string& name : names()) {
    meter_->charge(std::filesystem::file_size(path_of(name)), path_of(name));
  }
}

ScratchDirectory::~ScratchDirectory() {
  if (!is_kept_) remove_folder(path_.c_str());
}

void ScratchDirectory::keep() noexcept {
  is_kept_ = true;
  if (temporary_) temporary_->keep();
}

std::string ScratchDirectory::path_of(const std::string& name) const {
  if (name.empty() || name.find('/') != std::string::npos) {
    throw std::invalid_argument("a scratch file's name must be a plain name, not '" + name + "'");
  }
  return path_ + "/" + name;
}

File ScratchDirectory::create(const std::string& name) {
  return File::create(path_of(name), meter_);
}

File ScratchDirectory::open(const std::string& name) const {
  return File::open(path_of(name));
}

void ScratchDirectory::rename(const std::string& from, const std::string& to) {
  rename_path(path_of(from), path_of(to));
}

void ScratchDirectory::replace(const std::string& name, std::string_view text) {
  const std::string next = name + ".next";
  remove(next);
  File file = create(next);
  file.write(std::as_bytes(std::span(text)));
  file.close();
  std::error_code error;
  const std::uintmax_t replaced = std::filesystem::file_size(path_of(name), error);
  rename(next, name);
  if (!error) meter_->release(replaced);
}

bool ScratchDirectory::has(const std::string& name) const {
  return path_exists(path_of(name));
}

std::vector<std::string> ScratchDirectory::names() const {
  return list_folder(path_);
}

void ScratchDirectory::remove(const std::string& name) {
  const std::string path = path_of(name);
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(path, error);
  if (error) return;
  remove_file(path.c_str());
  meter_->release(bytes);
}

std::vector<std::string> scratch_folders(const std::string& parent) {
  std::vector<std::string> folders;
  for (const std::string& name : list_folder(parent)) {
    if (!is_temporary_name_beside(name, kFolderName)) continue;
    folders.push_back(std::filesystem::path(parent) / name);
  }
  return folders;
}

std::string default_scratch_parent(const std::string& output_path) {
  if (output_path != "-") return parent_folder(output_path);
  const char* folder = std::getenv("TMPDIR");  // NOLINT(concurrency-mt-unsafe): read only
  return folder != nullptr && *folder != '\0' ? folder : "/var/tmp";
}

}  // namespace stream_recon
