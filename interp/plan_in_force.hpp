// The phases of the plan that is in force at a tick.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>

#include "interp/motion_queue.hpp"

namespace kerf::interp {

// Of the thread that ticks, but for answer().
class PlanInForce {
 public:
  explicit PlanInForce(MotionQueue& queue) noexcept : queue_(&queue) {}

  // At its tick a new plan replaces the present one. One that comes later than that is refused: the
  // tool is somewhere else by then; so is one that would replace another plan. tick: of the plan's
  // time.
  void take_over(std::int64_t tick) noexcept;

  // The next phase; null: there is none.
  [[nodiscard]] const Phase* next_phase() const noexcept {
    if (stop_next_ < stop_.count) {
      return &stop_.phases[stop_next_];
    }
    const Phase* next = queue_->next_phase();
    return next != nullptr && next->plan == plan_ ? next : nullptr;
  }
  void pop_phase() noexcept {
    if (stop_next_ < stop_.count) {
      ++stop_next_;
    } else {
      queue_->pop_phase();
    }
  }

  // From the phase on, at the instant, the motion follows these laws, to rest: a plan of its own,
  // of the number that it returns. What the planning side has made is dropped.
  struct BrakeFrom {
    TickTime begin{};
    double s_mm = 0.0;
    double period_s = 0.001;
  };
  // Numbers of the planning side are even, those of brakes odd and above all before; answer() keeps
  // the plan that was braked.
  std::uint32_t brake(const Phase& phase, std::span<const profiles::CellLaw> laws,
                      const BrakeFrom& from) noexcept;
  // How the latest plan that was to take over was taken. May be read by the planning thread.
  struct Answer {
    std::uint32_t plan = 0;      // the latest that was accepted or refused, or a stop ahead
    std::uint32_t in_force = 0;  // the latest that was accepted
  };
  [[nodiscard]] Answer answer() const noexcept {
    const std::uint64_t both = answer_.load(std::memory_order_acquire);
    return {.plan = static_cast<std::uint32_t>(both >> 32U),
            .in_force = static_cast<std::uint32_t>(both)};
  }

 private:
  [[nodiscard]] bool may_take(const Takeover& next, std::int64_t tick) const noexcept;
  // Takes the stop ahead where this is its tick.
  void take_stop(std::int64_t tick) noexcept;
  // Phases of plans that were superseded or never taken.
  void drop_stale_phases() noexcept;
  void give_answer(std::uint32_t plan) noexcept {
    answer_.store(std::uint64_t{plan} << 32U | told_plan_, std::memory_order_release);
  }

  MotionQueue* queue_;
  std::uint32_t plan_ = 0;
  std::uint32_t told_plan_ = 0;            // the latest of the planning side
  StopAhead stop_{};                       // the latest that was taken
  std::size_t stop_next_ = 0;              // its next phase; the count: it has begun the last one
  std::atomic<std::uint64_t> answer_ = 0;  // Answer: plan, in_force
};

}  // namespace kerf::interp
