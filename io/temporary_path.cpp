#include "io/temporary_path.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <cstdio>
#include <deque>
#include <exception>
#include <filesystem>
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

constexpr std::string_view kMark = ".partial-";
constexpr std::size_t kDigits = 16;
constexpr std::size_t kProcessDigits = 12;

/// Those of the process, then a count. Random, not the process id: containers that share a disk
/// have equal process ids; with it, since a child begins with its parent's memory.
std::string next_digits() {
  static std::mutex mutex;
  static std::uint32_t own = 0;
  static std::uint16_t count = 0;
  const std::lock_guard lock(mutex);
  if (count == 0) own = std::random_device()();
  std::array<char, kDigits + 1> digits{};
  std::snprintf(digits.data(), digits.size(), "%08x%04x%04x", own,
                static_cast<unsigned>(getpid()) & 0xffff, static_cast<unsigned>(count++));
  return digits.data();
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
  return path + std::string(kMark) + next_digits();
}

bool is_temporary_name_beside(std::string_view name, std::string_view base) {
  if (!name.starts_with(base)) return false;
  name.remove_prefix(base.size());
  if (!name.starts_with(kMark)) return false;
  name.remove_prefix(kMark.size());
  return name.size() == kDigits && std::all_of(name.begin(), name.end(), [](char c) {
           return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f');
         });
}

void remove_left_beside(const std::string& path, const std::string& of_process) noexcept {
  try {
    const std::string own = of_process.substr(of_process.size() - kDigits, kProcessDigits);
    const std::filesystem::path folder = parent_folder(path);
    const std::string base = std::filesystem::path(path).filename().string();
    for (const std::string& name : list_folder(folder.string())) {
      if (!is_temporary_name_beside(name, base)) continue;
      if (name.compare(base.size() + kMark.size(), kProcessDigits, own) != 0) continue;
      const std::string left = folder / name;
      remove_entry(left,
                   is_folder(left) ? TemporaryPath::Kind::kFolder : TemporaryPath::Kind::kFile);
    }
  } catch (const std::exception&) {
    // What cannot be listed cannot be tidied either: the run will say what is wrong with the
    // folder.
  }
}

void remove_temporary_paths() noexcept {
  for (auto& slot : slots) {
    const Entry* entry = slot.load();
    if (entry != nullptr) remove_entry(entry->path, entry->kind);
  }
}

}  // namespace stream_recon
