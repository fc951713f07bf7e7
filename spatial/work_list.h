// A list that is filled without a check per element: room is made ahead, elements are written
// whether or not they will count.
#pragma once

#include <cstddef>
#include <vector>

namespace stream_recon::detail {

template <class T>
class WorkList {
 public:
  void clear() { size_ = 0; }
  /// Makes room for `count` elements behind the end. Pointers become invalid.
  void make_room(std::size_t count) {
    if (size_ + count > elements_.size()) elements_.resize(2 * (size_ + count));
  }
  /// \pre make_room() covered all positions written and grown by
  T* end() { return elements_.data() + size_; }
  void grow(std::size_t count) { size_ += count; }

  const T* begin() const { return elements_.data(); }
  const T* end() const { return elements_.data() + size_; }
  std::size_t size() const { return size_; }
  const T& operator[](std::size_t i) const { return elements_[i]; }
  std::size_t bytes() const { return elements_.capacity() * sizeof(T); }

 private:
  std::vector<T> elements_;
  std::size_t size_ = 0;
};

}  // namespace stream_recon::detail
