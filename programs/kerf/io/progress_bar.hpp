// A bar on the terminal for work that takes longer than a second.
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace kerf::program {

// One line of text: "running  [#####     ]  51 %".
[[nodiscard]] std::string progress_line(const std::string& label, double share);

// Draws on standard error, ten times a second from the first second on, in a thread of its own: a
// terminal that is stopped stops nothing else. Gone without a trace when destroyed.
class ProgressBar {
 public:
  // label, share (0..1): called from the other thread. shown: false makes the whole thing do
  // nothing.
  ProgressBar(std::function<std::string()> label, std::function<double()> share, bool shown);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  // Is there a terminal to draw on?
  [[nodiscard]] static bool has_terminal() noexcept;

 private:
  void draw();

  std::function<std::string()> label_;
  std::function<double()> share_;
  std::mutex mutex_;
  std::condition_variable over_;
  bool is_over_ = false;
  std::thread thread_;
};

}  // namespace kerf::program
