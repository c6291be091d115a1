// The person at the terminal of a run.
#pragma once

#include <atomic>
#include <mutex>
#include <string>
#include <thread>

#include "programs/kerf/control/operator.hpp"
#include "programs/kerf/io/keyboard.hpp"

namespace kerf::program {

// Space holds and resumes, Enter resumes, answers a wait and starts a program that waits for it, +
// and - change the feed override by 10 %, s switches single block, x, y and z move by 1 mm
// downwards where it is held or idle, X, Y and Z upwards, h homes, q stops, Esc is the emergency
// stop. Why a key did nothing is written to standard error. Keys are read, and that is written, in
// a thread of its own: a terminal that is stopped stops nothing else.
class Keys {
 public:
  // None where standard input is no terminal.
  explicit Keys(Operator& by);
  ~Keys();
  Keys(const Keys&) = delete;
  Keys& operator=(const Keys&) = delete;

  static constexpr const char* kWhatTheyDo =
      "keys: space holds and resumes, Enter goes on, + and - change the feed, s switches single "
      "block, xyz and XYZ jog by 1 mm while it is held, h homes, q stops on the path, Esc is the "
      "emergency stop";

 private:
  void read();
  // In the thread that plans.
  void press(char key);
  void move_by_hand(char key);
  void change_feed(int percent);

  void give(const OperatorOrder& order);
  void write_refusal();

  Operator* by_;
  Keyboard keyboard_;
  std::mutex mutex_;
  std::string refused_;  // why what was pressed last was not done; empty: it was, or is written
  std::atomic<bool> over_ = false;
  std::thread thread_;
};

}  // namespace kerf::program
