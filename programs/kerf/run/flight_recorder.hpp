// The ticks of the last seconds, for when something goes wrong.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "programs/kerf/report/tick_record.hpp"
#include "programs/kerf/run/trace_row.hpp"

namespace kerf::program {

class FlightRecorder {
 public:
  static constexpr double kLength_s = 5.0;
  static constexpr std::size_t kMaxTicks = 500'000;

  // Takes the memory that it needs. An infinite period: it keeps nothing.
  explicit FlightRecorder(double period_s)
      : ring_(std::min(kMaxTicks, static_cast<std::size_t>(kLength_s / period_s))) {}

  // For the tick: allocates nothing, and waits for nothing.
  void add(const TickRecord& record) noexcept {
    if (!ring_.empty()) {
      ring_[added_++ % ring_.size()] = record;
    }
  }

  // The oldest first. Not while ticks are added, as write().
  [[nodiscard]] std::vector<TickRecord> ticks() const;

  struct Target {
    const std::string& path;
    double period_s = 0.001;
    TraceColumns columns{};
  };
  // A CSV of the columns of a trace. Error: what the system says, with the path.
  [[nodiscard]] std::optional<std::string> write(const Target& target) const;

 private:
  std::vector<TickRecord> ring_;
  std::size_t added_ = 0;
};

}  // namespace kerf::program
