#include "engine/budget.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "engine/size_text.h"

namespace stream_recon {

Reservation::Reservation(Reservation&& other) noexcept
    : budget_(std::exchange(other.budget_, nullptr)),
      bytes_(std::exchange(other.bytes_, 0)),
      holder_(std::move(other.holder_)) {}

Reservation& Reservation::operator=(Reservation&& other) noexcept {
  if (this != &other) {
    if (budget_ != nullptr) budget_->change(bytes_, 0, holder_);
    budget_ = std::exchange(other.budget_, nullptr);
    bytes_ = std::exchange(other.bytes_, 0);
    holder_ = std::move(other.holder_);
  }
  return *this;
}

Reservation::~Reservation() {
  if (budget_ != nullptr) budget_->change(bytes_, 0, holder_);
}

void Reservation::resize(std::uint64_t bytes) {
  if (budget_ == nullptr) throw std::logic_error("a reservation without a budget was resized");
  budget_->change(bytes_, bytes, holder_);
  bytes_ = bytes;
}

Reservation MemoryBudget::reserve(std::uint64_t bytes, std::string_view holder) {
  Reservation reservation(this, holder);
  reservation.resize(bytes);
  return reservation;
}

std::uint64_t MemoryBudget::available() const {
  const std::lock_guard lock(mutex_);
  return limit_ - used_;
}

std::uint64_t MemoryBudget::used() const {
  const std::lock_guard lock(mutex_);
  return used_;
}

std::uint64_t MemoryBudget::peak() const {
  const std::lock_guard lock(mutex_);
  return peak_;
}

void MemoryBudget::change(std::uint64_t from, std::uint64_t to, std::string_view holder) {
  const std::lock_guard lock(mutex_);
  const std::uint64_t others = used_ - from;
  if (to > from && to > limit_ - others) {
    throw BudgetError(fmt::format(
        "memory budget: {} needs {} beside {} in use, but --memory is {}; give --memory {} or more",
        holder, size_text(to), size_text(others), size_text(limit_), size_argument(others + to)));
  }
  used_ = others + to;
  peak_ = std::max(peak_, used_);
}

}  // namespace stream_recon
