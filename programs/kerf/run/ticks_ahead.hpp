// The ticks of a program without a clock, in a thread of their own ahead of the machine's.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include <kerf/kernel.hpp>

#include "programs/kerf/run/planning_beside.hpp"

namespace kerf::program {

// Where the machine has no say in them, ticks are made ahead of it. While the program asks it
// something (G38, M66), they are made one by one in the thread that calls next(), with what it
// answers. So they are the same as in one thread.
class TicksAhead {
 public:
  struct Tick {
    Setpoint setpoint{};
    TickDetail detail{};
    TickStatus status = TickStatus::running;
  };

  TicksAhead(Kernel& kernel, PlanningBeside& planning);
  ~TicksAhead();
  TicksAhead(const TicksAhead&) = delete;
  TicksAhead& operator=(const TicksAhead&) = delete;

  // Not after the last one. said: by the machine, as of the tick before. An error of the other
  // threads is thrown here.
  template <typename Inputs>
  const Tick& next(const Inputs& said) {
    while (next_ == taken_.size()) {
      if (!makes_here_) {
        take();
      } else if (is_asked()) {
        kernel_->set_program_inputs(said());
        taken_.assign(1, make());
        next_ = 0;
      } else {
        give_back();
      }
    }
    return taken_[next_++];
  }

 private:
  static constexpr std::size_t kBatch = 256;

  // For the thread whose turn it is.
  bool is_asked();
  Tick make();

  void take();
  void give_back();

  void work() noexcept;
  void make_ahead();
  // What was made, to the caller, who makes the next ones by himself if the machine is asked.
  // False: no more are wanted.
  bool hand_over(bool is_asked);

  Kernel* kernel_;
  PlanningBeside* planning_;
  // Of the caller.
  std::vector<Tick> taken_;
  std::size_t next_ = 0;
  bool makes_here_ = false;
  // Of the thread.
  std::vector<Tick> made_;
  // Of both.
  std::mutex mutex_;
  std::condition_variable change_;
  std::vector<Tick> ready_;
  bool is_ready_ = false;
  bool is_asked_ = false;
  bool has_ended_ = false;
  bool over_ = false;
  std::exception_ptr error_;
  std::thread thread_;  // the last: it uses all of the above
};

}  // namespace kerf::program
