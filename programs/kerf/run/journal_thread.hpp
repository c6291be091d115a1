// Keeps the journal of a run while it goes on.
#pragma once

#include <atomic>
#include <thread>

#include <kerf/controller.hpp>

#include "programs/kerf/run/journal.hpp"

namespace kerf::program {

// In a thread of its own, which sees what any thread may see: once a second and where the tool
// comes to rest. A journal that cannot be written stops nothing.
class JournalThread {
 public:
  // Both outlive it.
  JournalThread(const Controller& controller, JournalWriter& writer);
  // No more is written.
  ~JournalThread();
  JournalThread(const JournalThread&) = delete;
  JournalThread& operator=(const JournalThread&) = delete;

 private:
  void work();

  const Controller* controller_;
  JournalWriter* writer_;
  std::atomic<bool> over_{false};
  std::thread thread_;
};

}  // namespace kerf::program
