// A file for libraries that read from C's FILE.
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <string>

#include "io/error.h"

namespace stream_recon {

struct CFileCloser {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using CFile = std::unique_ptr<std::FILE, CFileCloser>;

/// \throw InputError cannot be opened
inline CFile open_c_file(const std::string& path) {
  CFile file(std::fopen(path.c_str(), "rbe"));
  if (!file) throw InputError(fmt::format("{}: cannot open; check name and permissions", path));
  return file;
}

}  // namespace stream_recon
