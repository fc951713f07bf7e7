// All records of a chunk at once, from whatever visits them some at a time.
//
// Thread rule: as the source's visit(). Memory: the records, which the caller reserves.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace stream_recon {

/// \param source has count(chunk) and visit(chunk, visitor of spans) \throw as visit()
template <class Record, class Source>
std::vector<Record> gather_records(const Source& source, std::uint64_t chunk) {
  std::vector<Record> records;
  records.reserve(source.count(chunk));
  source.visit(chunk, [&records](std::span<const Record> part) {
    records.insert(records.end(), part.begin(), part.end());
  });
  return records;
}

}  // namespace stream_recon
