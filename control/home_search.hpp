// How axes find their home switches, one after the other.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <kerf/controller.hpp>

namespace kerf::control {

// Of each axis: off the switch if it is closed, towards it until it closes, back until it opens,
// slowly towards it again, and there the axis has its place, from which it goes home. Each move is
// ended by what the tick side sees; the place counts that the setpoint had then.
class HomeSearch {
 public:
  explicit HomeSearch(const MachineSettings& settings);

  [[nodiscard]] bool has_switches() const noexcept { return switches_ != 0; }
  // Any thread.
  [[nodiscard]] AxisSet unhomed() const noexcept { return unhomed_.load(); }
  void forget_homes() noexcept { unhomed_.store(switches_); }

  // Planning side, from here on: all axes that have a switch.
  void begin();
  struct Move {
    std::size_t axis = 0;
    double to_mm = 0.0;
    double mm_s = 0.0;
  };
  enum class Next : std::uint8_t {
    moves,
    waits,        // for the tick side: ask again
    gives_place,  // the same, and it is to be told of it
    done,
    failed,  // failure() says why
  };
  // At rest. `at`: where that is.
  Next next(const Setpoint& at, Move& move);
  // What the tick side has seen by now is what all this goes by.
  void look() noexcept {
    seen_ = {.closed = closed_.load(), .is_known = has_seen_.load(), .found = found_.load()};
  }
  // While it moves: what was looked for is there.
  [[nodiscard]] bool has_found() const noexcept { return seen_.found == looks_; }
  // While it moves; nothing: all is well.
  [[nodiscard]] std::optional<std::string> complaint(std::int64_t tick) const;
  [[nodiscard]] const std::string& failure() const noexcept { return failure_; }
  // A place was found, and setpoints do not have it yet. `at`: the latest of them.
  [[nodiscard]] bool is_placing(const Setpoint& at) const noexcept {
    return shifts_.load(std::memory_order_acquire) || at.tick < place_tick_;
  }
  // It is not to be given any more.
  void drop_place() noexcept { shifts_.store(false); }

  // Tick side, from here on. The switches that are closed, as of the last setpoint.
  void see(AxisSet closed, const Setpoint& last) noexcept;
  // At rest. True: an axis has another place from now on.
  bool take_place(Setpoint& last) noexcept;

 private:
  enum class Step : std::uint8_t { begin, clear, search, back_off, latch, place, go_home };

  [[nodiscard]] std::size_t axis() const { return order_[axes_done_]; }
  [[nodiscard]] const AxisHoming& of_axis() const { return homing_[axis()]; }
  [[nodiscard]] bool is_closed(std::size_t axis) const noexcept {
    return ((seen_.closed >> axis) & 1U) != 0;
  }
  // Until the switch is closed, or open.
  Next look(Step step, bool closed, const Move& move, std::int64_t tick, Move& out);
  [[nodiscard]] bool waits_for_switches(const Setpoint& at);
  Next begin_axis(const Setpoint& at, Move& move);
  Next look_for_it(const Setpoint& at, Move& move);
  Next back_off(Step step, const Setpoint& at, Move& move);
  Next latch(const Setpoint& at, Move& move);
  Next give_place();
  Next go_home(const Setpoint& at, Move& move);
  Next fail(const std::string& what);
  [[nodiscard]] std::string of_switch(const std::string& what) const;

  std::array<AxisHoming, 3> homing_;
  double period_s_;
  AxisSet switches_ = 0;
  std::atomic<AxisSet> unhomed_ = 0;
  std::vector<std::size_t> order_;
  std::size_t axes_done_ = 0;
  Step step_ = Step::begin;
  std::int64_t begun_tick_ = 0;
  bool waits_ = false;  // for the first look at the switches, since begun_tick_
  AxisSet closed_at_begin_ = 0;
  std::string failure_;
  struct Seen {
    AxisSet closed = 0;
    bool is_known = false;
    std::uint16_t found = 0;
  };
  Seen seen_{};
  std::uint16_t looks_ = 1;  // counts moves: what an earlier one finds late is not taken for this
  // Between the sides.
  // As aligned as it is large: clang calls a library for an atomic that is not.
  struct alignas(4) Watch {
    static constexpr std::uint8_t kNone = 0xff;
    std::uint8_t axis = kNone;
    bool closed = false;
    std::uint16_t look = 0;
  };
  static_assert(std::atomic<Watch>::is_always_lock_free);
  std::atomic<Watch> watch_{};
  std::atomic<AxisSet> closed_ = 0;
  std::atomic<bool> has_seen_ = false;    // closed_ is of the machine
  std::atomic<std::uint16_t> found_ = 0;  // the look that has found; written by the tick side alone
  std::atomic<double> found_mm_ = 0.0;
  std::atomic<bool> shifts_ = false;
  std::size_t shifted_axis_ = 0;  // written before shifts_ is set
  double shift_mm_ = 0.0;
  std::int64_t place_tick_ = 0;  // written before shifts_ is cleared: the first with that place
};

}  // namespace kerf::control
