#include "io/chunked_output.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "io/error.h"
#include "io/folder.h"

namespace stream_recon {
namespace {

constexpr std::string_view kChunkPrefix = "chunk_";

bool is_chunk_name(std::string_view name, std::string_view ending) {
  if (!name.starts_with(kChunkPrefix) || !name.ends_with(ending)) return false;
  name.remove_prefix(kChunkPrefix.size());
  name.remove_suffix(ending.size());
  return name.size() >= 6 &&
         std::all_of(name.begin(), name.end(), [](char c) { return c >= '0' && c <= '9'; });
}

std::string folder_of(const ChunkedOutput::Names& names) {
  std::string folder = names.index.substr(0, names.index.size() - names.index_ending.size());
  if (folder.empty() || folder.ends_with('/')) {
    throw std::invalid_argument("'" + names.index + "' lacks a name before " + names.index_ending);
  }
  return folder;
}

/// Replacing the folder removes what is in it, so nothing but chunks may be.
void require_replaceable(const std::string& folder, const std::string& chunk_ending) {
  if (!path_exists(folder)) return;
  const bool is_plain_folder = is_folder(folder) && !std::filesystem::is_symlink(folder);
  const auto names = is_plain_folder ? list_folder(folder) : std::vector<std::string>{""};
  const auto foreign = std::find_if_not(names.begin(), names.end(), [&](const std::string& name) {
    return is_chunk_name(name, chunk_ending);
  });
  if (foreign == names.end()) return;
  throw IoError("cannot replace " + folder +
                (is_plain_folder ? ": it holds " + *foreign + ", which is no chunk (" +
                                       std::string(kChunkPrefix) + "*" + chunk_ending + ")"
                                 : ", which is no folder of chunks") +
                "; move it or choose another name for the output");
}

TemporaryPath make_staging_folder(const std::string& folder, const std::string& chunk_ending) {
  require_replaceable(folder, chunk_ending);
  const std::string path = temporary_name_beside(folder);
  make_folder(path);
  return {path, TemporaryPath::Kind::kFolder};
}

}  // namespace

ChunkedOutput::ChunkedOutput(Names names)
    : names_(std::move(names)),
      folder_(folder_of(names_)),
      staging_(make_staging_folder(folder_, names_.chunk_ending)) {
  if (is_folder(names_.index)) throw_system_error("write", names_.index, EISDIR);
}

std::string ChunkedOutput::chunk_name(std::uint64_t number) const {
  std::array<char, 32> digits{};
  std::snprintf(digits.data(), digits.size(), "%06llu", static_cast<unsigned long long>(number));
  return std::string(kChunkPrefix) + digits.data() + names_.chunk_ending;
}

File ChunkedOutput::create_chunk(std::uint64_t number) {
  File file = File::create(staging_.path() + "/" + chunk_name(number));
  ++chunk_count_;
  return file;
}

std::vector<std::string> ChunkedOutput::chunk_paths() const {
  const std::string folder = std::filesystem::path(folder_).filename().string();
  std::vector<std::string> paths;
  for (std::uint64_t i = 0; i < chunk_count_; ++i) paths.push_back(folder + "/" + chunk_name(i));
  return paths;
}

void ChunkedOutput::prepare(const std::string& index_text) {
  // All at the end: by then the system has written most of them, and the first call the journal.
  for (std::uint64_t i = 0; i < chunk_count_; ++i) {
    File::open(staging_.path() + "/" + chunk_name(i)).sync();
  }
  sync_parent_folder(staging_.path() + "/" + chunk_name(0));
  File file = File::create(temporary_name_beside(names_.index));
  staged_index_.emplace(file.path(), TemporaryPath::Kind::kFile);
  file.write(std::as_bytes(std::span(index_text)));
  file.sync();
  file.close();
}

void ChunkedOutput::publish() {
  require_replaceable(folder_, names_.chunk_ending);
  old_index_ = temporary_name_beside(names_.index);
  old_folder_ = temporary_name_beside(folder_);
  if (path_exists(names_.index)) renames_.rename(names_.index, old_index_);
  if (path_exists(folder_)) renames_.rename(folder_, old_folder_);
  renames_.rename(staging_.path(), folder_);
  renames_.rename(staged_index_->path(), names_.index);
  sync_parent_folder(names_.index);
}

void ChunkedOutput::keep() noexcept {
  renames_.commit();
  staging_.keep();
  staged_index_->keep();
  remove_file(old_index_.c_str());
  remove_folder(old_folder_.c_str());
}

}  // namespace stream_recon
