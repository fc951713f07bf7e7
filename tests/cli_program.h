// The program stream-recon as a user calls it: a shell command, its exit code, what it said.
#pragma once

#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/io_test_folder.h"

namespace stream_recon {

struct Outcome {
  int exit_code = -1;
  std::string out;
  std::string error;
};

/// A folder to run commands in; the programs of this build come first in its PATH.
class CommandFolder {
 public:
  Outcome run(const std::string& command) const {
    const std::string script = "cd '" + folder_.path() +
                               "' && export PATH='" STREAM_RECON_BIN "':$PATH && { " + command +
                               "\n} >'" + log("out") + "' 2>'" + log("error") + "'";
    const int status = std::system(script.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, file_bytes(log("out")),
            file_bytes(log("error"))};
  }

  std::string path(const std::string& name) const { return folder_ / name; }
  bool has(const std::string& name) const { return std::filesystem::exists(path(name)); }
  std::string bytes(const std::string& name) const { return file_bytes(path(name)); }
  nlohmann::json json(const std::string& name) const { return nlohmann::json::parse(bytes(name)); }
  std::vector<std::string> names() const { return folder_.names(); }

  /// All bytes of a chunked result, but for its name.
  std::string chunked_bytes(const std::string& name, const std::string& ending) const {
    std::string all = bytes(name + ending);
    const std::string stem = name + "/";
    for (std::string::size_type at; (at = all.find(stem)) != std::string::npos;) {
      all.erase(at, stem.size());
    }
    for (const std::string& chunk : list_folder(path(name))) all += chunk + bytes(stem + chunk);
    return all;
  }

 private:
  std::string log(const std::string& name) const { return logs_ / name; }

  TestFolder folder_;
  TestFolder logs_;
};

}  // namespace stream_recon
