#include "io/temporary_path.h"

#include <array>
#include <atomic>
#include <cstdio>
#include <deque>
#include <mutex>
#include <random>
#include <stdexcept>
#include <utility>

#include "io/folder.h"

namespace stream_recon {
namespace {

struct Entry {
  std::string path;
  TemporaryPath::Kind kind;
};

constexpr std::size_t kSlots = 256;
constexpr std::size_t kNoSlot = kSlots;
std::array<std::atomic<const Entry*>, kSlots> slots{};

/// An entry that lives to the end of the process: a signal handler may hold a pointer to it.
const Entry* remember(const std::string& path, TemporaryPath::Kind kind) {
  static std::mutex mutex;
  static auto& entries = *new std::deque<Entry>;
  const std::lock_guard lock(mutex);
  return &entries.emplace_back(Entry{path, kind});
}

std::size_t occupy_slot(const Entry* entry) {
  for (std::size_t i = 0; i < kSlots; ++i) {
    const Entry* expected = nullptr;
    if (slots[i].compare_exchange_strong(expected, entry)) return i;
  }
  throw std::length_error("more than 256 temporary files and folders at once");
}

void remove_entry(const std::string& path, TemporaryPath::Kind kind) noexcept {
  if (kind == TemporaryPath::Kind::kFolder) {
    remove_folder(path.c_str());
  } else {
    remove_file(path.c_str());
  }
}

}  // namespace

TemporaryPath::TemporaryPath(std::string path, Kind kind)
    : path_(std::move(path)), kind_(kind), slot_(occupy_slot(remember(path_, kind))) {}

TemporaryPath::TemporaryPath(TemporaryPath&& other) noexcept
    : path_(std::move(other.path_)),
      kind_(other.kind_),
      slot_(std::exchange(other.slot_, kNoSlot)) {}

TemporaryPath::~TemporaryPath() {
  if (slot_ == kNoSlot) return;
  remove_entry(path_, kind_);
  slots[slot_].store(nullptr);
}

void TemporaryPath::keep() noexcept {
  if (slot_ != kNoSlot) slots[slot_].store(nullptr);
  slot_ = kNoSlot;
}

std::string temporary_name_beside(const std::string& path) {
  // Random, not the process id: containers that share a disk have equal process ids.
  std::random_device random;
  std::array<char, 17> digits{};
  std::snprintf(digits.data(), digits.size(), "%08x%08x", random(), random());
  return path + ".partial-" + digits.data();
}

void remove_temporary_paths() noexcept {
  for (auto& slot : slots) {
    const Entry* entry = slot.load();
    if (entry != nullptr) remove_entry(entry->path, entry->kind);
  }
}

}  // namespace stream_recon
