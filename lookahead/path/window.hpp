// A queue that keeps its memory: items that pass through are not allocated each time.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>

#include <boost/circular_buffer.hpp>

namespace kerf::lookahead {

// Grows when full, never shrinks. Elements are found by index; they move when it grows.
template <typename T>
class Window {
 public:
  void push_back(T&& value) {
    if (items_.full()) {
      items_.set_capacity(std::max<std::size_t>(16, 2 * items_.capacity()));
    }
    items_.push_back(std::move(value));
  }
  void pop_front() { items_.pop_front(); }
  // Drops everything after the first count.
  void keep_front(std::size_t count) { items_.erase_end(items_.size() - count); }

  [[nodiscard]] bool empty() const noexcept { return items_.empty(); }
  [[nodiscard]] std::size_t size() const noexcept { return items_.size(); }
  [[nodiscard]] T& operator[](std::size_t index) { return items_[index]; }
  [[nodiscard]] const T& operator[](std::size_t index) const { return items_[index]; }
  [[nodiscard]] T& front() { return items_.front(); }
  [[nodiscard]] T& back() { return items_.back(); }
  [[nodiscard]] const T& back() const { return items_.back(); }

 private:
  boost::circular_buffer<T> items_;
};

}  // namespace kerf::lookahead
