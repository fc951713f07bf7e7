#include "io/error.h"

#include <cerrno>
#include <system_error>

namespace stream_recon {
namespace {

std::string_view advice(int error_number) {
  switch (error_number) {
    case ENOSPC:
    case EDQUOT:
      return "free space or choose another place (--scratch for temporary files, -o for the "
             "result)";
    case EACCES:
    case EPERM:
      return "check the permissions of the file and its folder";
    case ENOENT:
    case ENOTDIR:
      return "check the path and create the folder";
    case EISDIR:
      return "name a file, not a folder";
    case EEXIST:
    case ENOTEMPTY:
      return "remove what is there or choose another name";
    case EROFS:
      return "choose a place that can be written";
    case EMFILE:
    case ENFILE:
      return "allow more open files (ulimit -n)";
    case EFBIG:
      return "allow larger files (ulimit -f) or choose another file system";
    case EPIPE:
      return "keep the program that reads the pipe running";
    case EIO:
      return "the device reported an error: check the disk and use another";
    default:
      return "check the path and the disk";
  }
}

}  // namespace

void throw_system_error(std::string_view what, std::string_view path, int error_number) {
  std::string message = "cannot ";
  message.append(what).append(" ").append(path).append(": ");
  message.append(std::generic_category().message(error_number)).append("; ");
  message.append(advice(error_number));
  throw IoError(message);
}

}  // namespace stream_recon
