// One value that a thread writes and others read whole, without a lock.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace kerf::control {

// A sequence lock [Boehm]: the number is odd while the writer writes, and who has read under two
// different numbers reads again. The words are atomic, so a torn read is no race. One writer; it
// never waits.
template <typename T>
class Snapshot {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  void write(const T& value) noexcept {
    Words words{};
    std::memcpy(words.data(), &value, sizeof(T));
    const std::uint64_t number = number_.load(std::memory_order_relaxed);
    number_.store(number + 1, std::memory_order_relaxed);
    std::atomic_thread_fence(std::memory_order_release);
    for (std::size_t i = 0; i < kWords; ++i) {
      words_[i].store(words[i], std::memory_order_relaxed);
    }
    number_.store(number + 2, std::memory_order_release);
  }

  [[nodiscard]] T read() const noexcept {
    Words words{};
    for (;;) {
      const std::uint64_t before = number_.load(std::memory_order_acquire);
      for (std::size_t i = 0; i < kWords; ++i) {
        words[i] = words_[i].load(std::memory_order_relaxed);
      }
      std::atomic_thread_fence(std::memory_order_acquire);
      if (before % 2 == 0 && number_.load(std::memory_order_relaxed) == before) {
        break;
      }
    }
    T value;
    std::memcpy(static_cast<void*>(&value), words.data(), sizeof(T));
    return value;
  }

 private:
  static constexpr std::size_t kWords = (sizeof(T) + 7) / 8;
  using Words = std::array<std::uint64_t, kWords>;

  std::atomic<std::uint64_t> number_ = 0;
  std::array<std::atomic<std::uint64_t>, kWords> words_{};
};

}  // namespace kerf::control
