// Counts ticks that find nothing planned.
#pragma once

#include <cstdint>

#include "programs/kerf/run/run_loop.hpp"

namespace kerf::program {

class StarvationJudge {
 public:
  explicit StarvationJudge(bool waits_for_text) noexcept : waits_for_text_(waits_for_text) {}

  void count(bool is_starved, RunOutcome& outcome) noexcept {
    starved_in_a_row_ = is_starved ? starved_in_a_row_ + 1 : 0;
    outcome.starved_ticks += is_starved ? 1 : 0;
    outcome.hung = starved_in_a_row_ >= kHungTicks && !waits_for_text_;
  }

 private:
  static constexpr std::uint64_t kHungTicks = 100'000;

  bool waits_for_text_;
  std::uint64_t starved_in_a_row_ = 0;
};

}  // namespace kerf::program
