// The progress of a program, shared between the threads that work and the one that shows it.
#pragma once

#include <algorithm>
#include <atomic>

namespace kerf::program {

// Writers store, nobody waits. Holds the share of the text that was read, the path length planned
// so far, and the tool's place on it.
class Progress {
 public:
  // Of the whole path as a check of the program found it; 0: there was none.
  explicit Progress(double whole_mm = 0.0) noexcept : whole_mm_(whole_mm) {}

  void set_read(double share) noexcept { read_.store(share, kOrder); }
  void set_planned(double length_mm) noexcept { planned_mm_.store(length_mm, kOrder); }
  void set_done(double s_mm) noexcept { done_mm_.store(s_mm, kOrder); }

  // 0..1. Without a check nobody knows how much path the text that is not read has: as much as that
  // which is.
  [[nodiscard]] double share() const noexcept {
    if (whole_mm_ > 0.0) {
      return std::clamp(done_mm_.load(kOrder) / whole_mm_, 0.0, 1.0);
    }
    const double planned = planned_mm_.load(kOrder);
    const double read = read_.load(kOrder);
    return planned > 0.0 ? std::clamp(done_mm_.load(kOrder) / planned, 0.0, 1.0) * read : 0.0;
  }
  [[nodiscard]] double read_share() const noexcept { return read_.load(kOrder); }

 private:
  static constexpr std::memory_order kOrder = std::memory_order_relaxed;
  double whole_mm_;
  std::atomic<double> read_{0.0};
  std::atomic<double> planned_mm_{0.0};
  std::atomic<double> done_mm_{0.0};
};

}  // namespace kerf::program
