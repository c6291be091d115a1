// A thread that the system lets go on before all others.
#pragma once

#include <string>
#include <vector>

#include "programs/kerf/io/descriptor.hpp"

namespace kerf::program {

// Makes the thread that constructs it one, until it is destroyed: SCHED_FIFO, on one processor,
// with the memory of the process locked and its stack touched, and processors kept out of deep
// sleep. What is not permitted is left out, and told.
class RealTimeThread {
 public:
  static constexpr int kPriority = 80;  // below the threads of interrupts, which have 50 and up

  RealTimeThread();
  ~RealTimeThread();
  RealTimeThread(const RealTimeThread&) = delete;
  RealTimeThread& operator=(const RealTimeThread&) = delete;

  // "SCHED_FIFO: Operation not permitted"; empty: all was.
  [[nodiscard]] const std::vector<std::string>& refusals() const noexcept { return refusals_; }

 private:
  void lock_memory();
  void keep_awake();
  void schedule();
  void note(const std::string& what, int error_number);

  std::vector<std::string> refusals_;
  Descriptor latency_;
};

}  // namespace kerf::program
