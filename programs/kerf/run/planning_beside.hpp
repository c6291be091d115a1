// Plans a program without a clock in a thread of its own, beside its ticks.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <exception>
#include <mutex>
#include <thread>

#include <kerf/kernel.hpp>

#include "programs/kerf/run/feeder.hpp"

namespace kerf::program {

// The ticks are those of one thread: one that needs what is not planned yet waits for it. All
// members are for the thread of the ticks; an error of the other thread is thrown there.
class PlanningBeside {
 public:
  PlanningBeside(Kernel& kernel, Feeder& feeder);
  ~PlanningBeside();
  PlanningBeside(const PlanningBeside&) = delete;
  PlanningBeside& operator=(const PlanningBeside&) = delete;

  // Before each tick.
  void reach_tick();
  // Waits for a plan that begins now. After the last tick: what the kernel says may be read from
  // then on.
  void await_plan();

 private:
  // So many ticks make room for more to plan.
  static constexpr int kTicksOfRoom = 512;

  // Waits until it has more. True: no more is planned.
  bool lacks_plan();
  void work() noexcept;
  void plan();
  // Returns the number of the next plan that begins.
  std::uint64_t ask();
  // True: that plan has ended. Comes back before that, for something may be planned by then.
  bool wait_for(std::uint64_t number);

  Kernel* kernel_;
  Feeder* feeder_;
  int ticks_ = 0;  // since it was asked last
  std::mutex mutex_;
  std::condition_variable asked_change_;
  std::condition_variable done_change_;
  std::uint64_t asked_ = 0;
  std::uint64_t done_ = 0;
  bool over_ = false;
  std::exception_ptr error_;
  std::thread thread_;  // the last: it uses all of the above
};

}  // namespace kerf::program
