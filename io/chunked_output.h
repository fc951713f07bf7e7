// An index and the folder of chunks it names, which appear together, complete or not at all.
//
// Guarantees: chunks are written in a folder of another name; prepare() forces them and the index,
// under another name, to the device; publish() lets an older result step aside, index first, gives
// the folder its name, then the index: a readable index means a complete result, never a mixed one.
// Until keep() an object that goes takes its result away and puts the older one back. A folder of
// that name with files that are no chunks is refused at the start.
// Thread rule: one thread, but create_chunk() is thread-safe. Memory: the names.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/file.h"
#include "io/rename_sequence.h"
#include "io/temporary_path.h"

namespace stream_recon {

class ChunkedOutput {
 public:
  struct Names {
    std::string index;         ///< path of the index
    std::string index_ending;  ///< ".pvtp"; without it the path is that of the folder
    std::string chunk_ending;  ///< ".vtp"
  };

  /// \throw IoError cannot create; std::invalid_argument the name is nothing but its ending
  explicit ChunkedOutput(Names names);

  /// A chunk by its number, to be filled and closed. Numbers come in any order; in the end they are
  /// 0, 1, ... without a gap. \throw IoError
  File create_chunk(std::uint64_t number);
  /// Paths of the chunks as the index, which lies beside the folder, says them.
  std::vector<std::string> chunk_paths() const;

  /// No more chunks. \throw IoError
  void prepare(const std::string& index_text);
  /// \pre prepare() \throw IoError
  void publish();
  /// The result stays, an older one is removed. \pre publish()
  void keep() noexcept;

 private:
  std::string chunk_name(std::uint64_t number) const;

  Names names_;
  std::string folder_;
  std::atomic<std::uint64_t> chunk_count_ = 0;
  std::string old_index_;
  std::string old_folder_;
  // The renames are undone before the staged files are removed: members go in reverse order.
  TemporaryPath staging_;
  std::optional<TemporaryPath> staged_index_;
  RenameSequence renames_;
};

}  // namespace stream_recon
