// A run as one self-contained page: figures, charts, pictures.
//
// Guarantees: no script, and nothing is loaded from anywhere; names are shown as text whatever is
// in them; light and dark by the reader's wish, and printable. Thread rule: pure functions.
#pragma once

#include <string>
#include <vector>

#include "engine/report.h"
#include "tools/html/run_pictures.h"

namespace stream_recon::html {

struct RunPage {
  Report report;
  std::vector<std::string> inputs;
  std::vector<std::string> outputs;
  std::vector<std::string> command;  ///< words of the command line
  std::string note;                  ///< a sentence, or nothing
  RunPictures pictures;
};

/// The whole page, UTF-8.
std::string run_page(const RunPage& page);

/// Puts it under `path`, complete or not at all; "-" is standard output. \throw IoError
void write_run_page(const RunPage& page, const std::string& path);

}  // namespace stream_recon::html
