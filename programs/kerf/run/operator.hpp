// What the person at the terminal asks of a run.
#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <thread>

#include <kerf/kernel.hpp>

#include "programs/kerf/io/keyboard.hpp"
#include "programs/kerf/io/progress.hpp"
#include "programs/kerf/run/feeder.hpp"

namespace kerf::program {

// Space holds and resumes, Enter resumes and answers a wait, + and - change the feed override by
// 10 %, s switches single block, q stops, Esc is the emergency stop. Keys are read in a thread of
// its own; what needs planning is carried out by the thread that plans, the emergency stop at once.
class Operator {
 public:
  // No keys where standard input is no terminal, or has_keys is false: the program comes from it.
  Operator(Kernel& kernel, bool has_keys);
  ~Operator();
  Operator(const Operator&) = delete;
  Operator& operator=(const Operator&) = delete;

  static constexpr const char* kKeys =
      "keys: space holds and resumes, Enter goes on, + and - change the feed, s switches single "
      "block, q stops on the path, Esc is the emergency stop";
  [[nodiscard]] bool has_keys() const noexcept { return thread_.joinable(); }
  // In the thread that plans.
  void carry_out(Feeder& feeder);
  // Any thread.
  void emergency_stop() noexcept;
  [[nodiscard]] bool asked_to_stop() const noexcept { return stop_; }
  [[nodiscard]] bool asked_for_emergency_stop() const noexcept { return emergency_; }
  // The state, and in a run its line, feedrate, feed override and single block.
  [[nodiscard]] std::string status_line(const Progress& progress) const;

 private:
  [[nodiscard]] const char* state_after(TickStatus status) const noexcept;
  void read_keys();
  void press(char key) noexcept;

  Kernel* kernel_;
  std::optional<Keyboard> keyboard_;
  std::atomic<bool> hold_ = false;  // is asked for
  std::atomic<bool> answer_ = false;
  std::atomic<bool> stop_ = false;
  std::atomic<bool> emergency_ = false;
  std::atomic<int> feed_percent_ = 100;
  std::atomic<bool> single_block_ = false;
  // What was asked of the kernel; of the thread that plans.
  int carried_feed_percent_ = 100;
  bool carried_single_block_ = false;
  bool held_ = false;
  std::atomic<bool> over_ = false;
  std::thread thread_;
};

}  // namespace kerf::program
