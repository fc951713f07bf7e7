// A file or folder that must not outlive the run unless it is kept.
//
// Guarantees: the destructor removes what stands at the path, and remove_temporary_paths() removes
// all of them at once from a signal handler. Memory: the path's bytes, held to the end of the
// process, since a signal handler may be reading them; a run makes a handful.
// Thread rule: objects belong to one thread each; construction and destruction are thread-safe.
#pragma once

#include <cstddef>
#include <string>

namespace stream_recon {

class TemporaryPath {
 public:
  enum class Kind { kFile, kFolder };

  /// Takes charge of `path`. Make the file or folder first: what another run made is not ours.
  TemporaryPath(std::string path, Kind kind);
  TemporaryPath(TemporaryPath&& other) noexcept;
  TemporaryPath& operator=(TemporaryPath&&) = delete;
  ~TemporaryPath();

  /// Lets what stands at the path live on.
  void keep() noexcept;

  const std::string& path() const { return path_; }

 private:
  std::string path_;
  Kind kind_;
  std::size_t slot_;
};

/// A name beside `path` that nobody else uses: `path` + ".partial-" + 16 random hex digits.
std::string temporary_name_beside(const std::string& path);

/// Removes all temporary paths of the process. Safe in a signal handler; the process should end
/// after it (_exit).
void remove_temporary_paths() noexcept;

}  // namespace stream_recon
