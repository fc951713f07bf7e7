// Names on disk: folders, renames, removals.
//
// Guarantees: a call does its work or throws an IoError that names path and reason; a rename is
// atomic. The remove functions never throw, because they run while errors unwind.
// Thread rule: thread-safe where the file system is.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace stream_recon {

/// \throw IoError cannot create, or something of that name exists
void make_folder(const std::string& path);

/// Puts `from` under the name `to`, replacing a file of that name in one step. \throw IoError
void rename_path(const std::string& from, const std::string& to);

/// Forces the names in the folder that holds `path` to the device. \throw IoError
void sync_parent_folder(const std::string& path);

/// The folder that holds `path`, "." for a bare name.
std::string parent_folder(const std::string& path);

/// Names in a folder, sorted. \throw IoError
std::vector<std::string> list_folder(const std::string& path);

/// Bytes that may still be written where the folder lies; all of 64 bits where the system does not
/// say.
std::uint64_t free_bytes(const std::string& folder);

/// Whether both folders share the room there is.
bool are_on_one_disk(const std::string& folder, const std::string& other);

bool path_exists(const std::string& path);
bool is_folder(const std::string& path);

/// Removes a file, if it is there. Safe in a signal handler.
void remove_file(const char* path) noexcept;

/// Removes a folder and the files in it; folders in it stay, and so does it then. Safe in a signal
/// handler.
void remove_folder(const char* path) noexcept;

}  // namespace stream_recon
