#include "io/folder.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <limits>
#include <system_error>

#include "io/error.h"
#include "io/fault_injection.h"

namespace stream_recon {
namespace {

/// Removes the files that one pass over an open folder finds; whether there were any.
bool remove_entries(int folder) noexcept {
  // getdents64 because readdir allocates, which a signal handler must not.
  alignas(dirent64) char buffer[4096];
  bool removed = false;
  ssize_t bytes = 0;
  while ((bytes = ::getdents64(folder, buffer, sizeof buffer)) > 0) {
    for (ssize_t at = 0; at < bytes;) {
      const auto* entry = reinterpret_cast<const dirent64*>(buffer + at);
      const bool is_link_to_folder =
          std::strcmp(entry->d_name, ".") == 0 || std::strcmp(entry->d_name, "..") == 0;
      if (!is_link_to_folder && ::unlinkat(folder, entry->d_name, 0) == 0) removed = true;
      at += entry->d_reclen;
    }
  }
  return removed;
}

}  // namespace

void make_folder(const std::string& path) {
  int error = detail::injected_error(IoOperation::kMakeDirectory);
  if (error == 0 && ::mkdir(path.c_str(), 0777) != 0) error = errno;
  if (error != 0) throw_system_error("create folder", path, error);
}

void rename_path(const std::string& from, const std::string& to) {
  int error = detail::injected_error(IoOperation::kRename);
  if (error == 0 && std::rename(from.c_str(), to.c_str()) != 0) error = errno;
  if (error != 0) throw_system_error("rename " + from + " to", to, error);
}

void sync_parent_folder(const std::string& path) {
  const std::string folder = parent_folder(path);
  int error = detail::injected_error(IoOperation::kSync);
  if (error == 0) {
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) throw_system_error("open folder", folder, errno);
    // Some network file systems cannot sync a folder and say EINVAL.
    if (::fsync(descriptor) != 0 && errno != EINVAL) error = errno;
    ::close(descriptor);
  }
  if (error != 0) throw_system_error("force to disk folder", folder, error);
}

std::string parent_folder(const std::string& path) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

std::vector<std::string> list_folder(const std::string& path) {
  std::vector<std::string> names;
  std::error_code error;
  std::filesystem::directory_iterator entry(path, error);
  for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
    names.push_back(entry->path().filename().string());
  }
  if (error) throw_system_error("list folder", path, error.value());
  std::sort(names.begin(), names.end());
  return names;
}

std::uint64_t free_bytes(const std::string& folder) {
  std::error_code error;
  const auto space = std::filesystem::space(folder, error);
  return error ? std::numeric_limits<std::uint64_t>::max() : space.available;
}

bool are_on_one_disk(const std::string& folder, const std::string& other) {
  struct stat one {};
  struct stat two {};
  return ::stat(folder.c_str(), &one) == 0 && ::stat(other.c_str(), &two) == 0 &&
         one.st_dev == two.st_dev;
}

bool path_exists(const std::string& path) {
  struct stat status {};
  return ::lstat(path.c_str(), &status) == 0;
}

bool is_folder(const std::string& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 && S_ISDIR(status.st_mode);
}

void remove_file(const char* path) noexcept {
  ::unlink(path);
}

void remove_folder(const char* path) noexcept {
  const int folder = ::open(path, O_RDONLY | O_DIRECTORY | O_CLOEXEC | O_NOFOLLOW);
  if (folder < 0) return;
  // Removing while listing may skip entries, so list again until a pass finds nothing to remove.
  while (remove_entries(folder)) ::lseek(folder, 0, SEEK_SET);
  ::close(folder);
  ::rmdir(path);
}

}  // namespace stream_recon
