// Which border node a node of a part hangs on, and whether it lies on the same side.
//
// Thread rule: a value. Memory: 4 bytes.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

namespace stream_recon {

/// A border node hangs on itself. A node from which no evidence leads to the border hangs on
/// nothing.
struct Attachment {
  static constexpr std::uint32_t kMostNodes = std::uint32_t{1} << 30;

  std::uint32_t node : 30 = 0;  ///< number of the border node, if it hangs on one
  bool is_attached : 1 = false;
  bool is_opposite : 1 = false;

  friend bool operator==(const Attachment&, const Attachment&) = default;
};

static_assert(sizeof(Attachment) == 4);

/// How many hang on nothing.
inline std::uint64_t count_unattached(std::span<const Attachment> attachments) {
  return static_cast<std::uint64_t>(
      std::count_if(attachments.begin(), attachments.end(),
                    [](const Attachment& at) { return !at.is_attached; }));
}

}  // namespace stream_recon
