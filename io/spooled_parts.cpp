#include "io/spooled_parts.h"

#include <algorithm>
#include <atomic>

namespace stream_recon {
namespace {

constexpr std::uint64_t kPiece = std::uint64_t{1} << 20;

std::string new_name() {
  static std::atomic<unsigned> counter{0};
  return "part-" + std::to_string(counter++);
}

}  // namespace

SpooledParts::SpooledParts(ScratchDirectory& scratch, std::size_t count) : scratch_(scratch) {
  parts_.reserve(count);
  while (parts_.size() < count) {
    std::string name = new_name();
    File file = scratch_.create(name);
    parts_.push_back({std::move(name), std::move(file)});
  }
}

SpooledParts::~SpooledParts() {
  for (Part& part : parts_) {
    if (part.file.is_open()) scratch_.remove(part.name);
  }
}

void SpooledParts::append(std::size_t part, std::span<const std::byte> bytes) {
  parts_[part].file.write(bytes);
}

void SpooledParts::move_to(std::size_t part, File& target) {
  auto& [name, file] = parts_[part];
  const std::uint64_t size = file.position();
  std::vector<std::byte> piece(std::min(size, kPiece));
  for (std::uint64_t at = 0; at < size; at += piece.size()) {
    piece.resize(std::min<std::uint64_t>(piece.size(), size - at));
    file.read_at(at, piece);
    target.write(piece);
  }
  file = File();
  scratch_.remove(name);
}

}  // namespace stream_recon
