// Keeps the journal of a run while it goes on.
#pragma once

#include <atomic>
#include <thread>

#include "programs/kerf/control/operator.hpp"
#include "programs/kerf/run/journal.hpp"

namespace kerf::program {

// In a thread of its own, which sees what any thread may see: once a second and where the tool
// comes to rest, and as soon as somebody has changed what the program does. A journal that cannot
// be written stops nothing.
class JournalThread {
 public:
  // Both outlive it.
  JournalThread(const Operator& by, JournalWriter& writer);
  // No more is written.
  ~JournalThread();
  JournalThread(const JournalThread&) = delete;
  JournalThread& operator=(const JournalThread&) = delete;

 private:
  void work();

  const Operator* by_;
  JournalWriter* writer_;
  std::atomic<bool> over_{false};
  std::thread thread_;
};

}  // namespace kerf::program
