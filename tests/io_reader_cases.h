// A small file of every format and flavour, with what must be read from it.
#pragma once

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

#include "io/point_source.h"

namespace stream_recon {

struct ReaderCase {
  std::string name;
  InputFormat format = InputFormat::kAuto;  ///< what it is; kAuto finds it unless it is raw
  std::string bytes;
  std::vector<Point3> points;
  std::size_t header = 0;  ///< bytes before the first point's
  bool counted = true;     ///< whether a cut is always noticed
};

inline std::ostream& operator<<(std::ostream& out, const ReaderCase& reader_case) {
  return out << reader_case.name;
}

std::vector<ReaderCase> reader_cases();

}  // namespace stream_recon
