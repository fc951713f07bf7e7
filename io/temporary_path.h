// A file or folder that must not outlive the run unless it is kept.
//
// Guarantees: the destructor removes what stands at the path, and remove_temporary_paths() removes
// all of them at once from a signal handler. Memory: the path's bytes, held to the end of the
// process, since a signal handler may be reading them; a run makes a handful.
// Thread rule: objects belong to one thread each; construction and destruction are thread-safe.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

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

/// A name beside `path` that nobody else uses: `path` + ".partial-" + 16 hex digits, of which the
/// first 12 are the process' own and random.
std::string temporary_name_beside(const std::string& path);

/// Whether temporary_name_beside(`base`) may be `name`.
bool is_temporary_name_beside(std::string_view name, std::string_view base);

/// Removes what the process that made the temporary name `of_process` has left beside `path`.
/// \pre That process is no more.
void remove_left_beside(const std::string& path, const std::string& of_process) noexcept;

/// Removes all temporary paths of the process. Safe in a signal handler; the process should end
/// after it (_exit).
void remove_temporary_paths() noexcept;

}  // namespace stream_recon
