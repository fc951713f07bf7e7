// The files that a text header names for its voxels.
#pragma once

#include <istream>
#include <string>
#include <vector>

namespace stream_recon {

/// `value` is one of: a name; LIST, the names following line by line in `rest`; a pattern with %d
/// or %03d and the first number, the last and the step. A number of dimensions behind the last two
/// is read over. Names are relative to the folder of `header_path`. Empty if `value` says none.
/// \throw InputError more than a million files
std::vector<std::string> named_data_files(const std::string& header_path, const std::string& value,
                                          std::istream& rest);

/// Without blanks, tabs and carriage returns at either end.
std::string trimmed(const std::string& text);

}  // namespace stream_recon
