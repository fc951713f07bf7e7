// An array that grows in place of its pages: growing copies nothing and touches nothing.
//
// Guarantees: memory counts as resident only for the part that was written; growth moves page
// tables, not elements, so that no second copy ever exists. One element's worth of slack behind
// the end may be read (vector loads of a last element).
// Thread rule: one writer. Elements are trivially copyable and start as zero bytes.
#pragma once

#include <cstddef>
#include <new>
#include <type_traits>
#include <utility>

#include "spatial/page_memory.h"

namespace stream_recon {

template <class T>
class GrowableArray {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  GrowableArray() = default;
  GrowableArray(GrowableArray&& other) noexcept
      : data_(std::exchange(other.data_, nullptr)), capacity_(std::exchange(other.capacity_, 0)) {}
  GrowableArray& operator=(GrowableArray&& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(capacity_, other.capacity_);
    return *this;
  }
  ~GrowableArray() { release_pages(data_, bytes(capacity_)); }

  /// Makes room for `count` elements. Pointers into the array become invalid.
  /// \throw std::bad_alloc no address space
  void reserve(std::size_t count) {
    if (count <= capacity_) return;
    data_ = static_cast<T*>(grow_pages(data_, bytes(capacity_), bytes(count)));
    capacity_ = count;
  }

  std::size_t capacity() const { return capacity_; }
  T* data() { return data_; }
  const T* data() const { return data_; }
  T& operator[](std::size_t i) { return data_[i]; }
  const T& operator[](std::size_t i) const { return data_[i]; }

 private:
  static std::size_t bytes(std::size_t count) { return count == 0 ? 0 : (count + 1) * sizeof(T); }

  T* data_ = nullptr;
  std::size_t capacity_ = 0;
};

}  // namespace stream_recon
