// A bar on the terminal for work that takes longer than a second.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace kerf::program {

struct ProgressShown {
  double share = 0.0;              // 0..1
  std::optional<double> left_s{};  // nothing: not said
};

// One line of text: "running  [#####     ]  51 %, 12 s left". Where that is more than there are
// columns, the bar is shorter, then left out; then the end is cut off.
[[nodiscard]] std::string progress_line(const std::string& label, const ProgressShown& shown,
                                        std::size_t columns);

// What is left of work of which the share was done in the time: as much a share as before. Nothing:
// too little is done to say.
struct WorkDone {
  double elapsed_s = 0.0;
  double share = 0.0;
};
[[nodiscard]] std::optional<double> left_s_of(const WorkDone& done) noexcept;

// Draws on standard error, ten times a second from the first second on, in a thread of its own: a
// terminal that is stopped stops nothing else. Never wider than the terminal is just then: a line
// that wraps would be a new one each time. Gone without a trace when destroyed.
class ProgressBar {
 public:
  enum class Left : unsigned char { estimated, not_said };

  // label, share (0..1): called from the other thread. shown: false makes the whole thing do
  // nothing.
  ProgressBar(std::function<std::string()> label, std::function<double()> share, bool shown,
              Left left = Left::estimated);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  // Is there a terminal to draw on?
  [[nodiscard]] static bool has_terminal() noexcept;
  // What is written before a line of another kind takes the bar's place; empty without a terminal.
  [[nodiscard]] static const char* before_a_line() noexcept {
    return has_terminal() ? "\r\x1b[K" : "";
  }

 private:
  void draw();

  std::function<std::string()> label_;
  std::function<double()> share_;
  Left left_;
  std::mutex mutex_;
  std::condition_variable over_;
  bool is_over_ = false;
  std::thread thread_;
};

}  // namespace kerf::program
