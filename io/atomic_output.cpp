#include "io/atomic_output.h"

#include <cerrno>
#include <filesystem>
#include <span>
#include <utility>

#include "io/error.h"
#include "io/folder.h"

namespace stream_recon {

File create_beside(const std::string& path) {
  // A rename onto a folder fails only at the end of the run: say so at its start.
  if (is_folder(path)) throw_system_error("write", path, EISDIR);
  // A device or a pipe would be replaced by a file.
  if (std::filesystem::exists(path) && !std::filesystem::is_regular_file(path)) {
    throw IoError("cannot write " + path +
                  ": not a regular file; take a file's name, or - and a pipe");
  }
  return File::create(temporary_name_beside(path));
}

AtomicOutput::AtomicOutput(std::string path)
    : path_(std::move(path)),
      file_(create_beside(path_)),
      temporary_(file_.path(), TemporaryPath::Kind::kFile) {}

void AtomicOutput::prepare() {
  file_.sync();
  file_.close();
}

void AtomicOutput::commit() {
  if (file_.is_open()) prepare();
  rename_path(temporary_.path(), path_);
  temporary_.keep();
  try {
    sync_parent_folder(path_);
  } catch (...) {
    remove_file(path_.c_str());  // the caller is told there is no result, so let there be none
    throw;
  }
}

void write_output(const std::string& path, std::string_view bytes) {
  const auto data = std::as_bytes(std::span(bytes));
  if (path == "-") {
    File::standard_output().write(data);
    return;
  }
  AtomicOutput output(path);
  output.file().write(data);
  output.commit();
}

}  // namespace stream_recon
