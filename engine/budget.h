// The memory of a run as one number that every sizeable holder takes its part of.
//
// Guarantees: the sum of all live reservations never exceeds the limit; a reservation gives its
// bytes back when it goes. Reservations are promises, not allocations: reserve first, then allocate
// at most that much. Thread rule: all calls of MemoryBudget are thread-safe; a Reservation belongs
// to one thread at a time. Memory: a few words.
#pragma once

#include <cstdint>
#include <mutex>
#include <stdexcept>
#include <string>
#include <string_view>

namespace stream_recon {

/// The run does not fit its memory: exit code 69. The message has the numbers.
class BudgetError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class MemoryBudget;

/// Bytes taken from a budget, given back at the end of its life.
class Reservation {
 public:
  Reservation() = default;
  Reservation(Reservation&& other) noexcept;
  Reservation& operator=(Reservation&& other) noexcept;
  ~Reservation();

  /// Takes more or gives some back. \throw BudgetError nothing is changed then
  void resize(std::uint64_t bytes);
  std::uint64_t bytes() const { return bytes_; }

 private:
  friend class MemoryBudget;
  Reservation(MemoryBudget* budget, std::string_view holder) : budget_(budget), holder_(holder) {}

  MemoryBudget* budget_ = nullptr;
  std::uint64_t bytes_ = 0;
  std::string holder_;
};

class MemoryBudget {
 public:
  explicit MemoryBudget(std::uint64_t limit_bytes) : limit_(limit_bytes) {}
  MemoryBudget(const MemoryBudget&) = delete;
  MemoryBudget& operator=(const MemoryBudget&) = delete;

  /// \param holder what the memory is for, as the user should read it
  /// \throw BudgetError it does not fit beside what is taken
  Reservation reserve(std::uint64_t bytes, std::string_view holder);

  std::uint64_t limit() const { return limit_; }
  std::uint64_t available() const;
  std::uint64_t used() const;
  std::uint64_t peak() const;

 private:
  friend class Reservation;
  void change(std::uint64_t from, std::uint64_t to, std::string_view holder);

  const std::uint64_t limit_;
  mutable std::mutex mutex_;
  std::uint64_t used_ = 0;
  std::uint64_t peak_ = 0;
};

}  // namespace stream_recon
