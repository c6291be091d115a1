#include "programs/kerf/io/progress_bar.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <unistd.h>
#include <utility>

#include <spdlog/fmt/fmt.h>

#include "programs/kerf/io/descriptor.hpp"

namespace kerf::program {

std::string progress_line(const std::string& label, double share) {
  constexpr std::size_t kWidth = 40;
  const double clamped = std::clamp(share, 0.0, 1.0);
  const auto full = static_cast<std::size_t>(clamped * static_cast<double>(kWidth));
  return fmt::format("{} [{}{}] {:3.0f} %", label, std::string(full, '#'),
                     std::string(kWidth - full, ' '), std::floor(clamped * 100.0));
}

bool ProgressBar::has_terminal() noexcept {
  const char* terminal = std::getenv("TERM");
  return ::isatty(STDERR_FILENO) == 1 &&
         (terminal == nullptr || std::string_view(terminal) != "dumb");
}

ProgressBar::ProgressBar(std::function<std::string()> label, std::function<double()> share,
                         bool shown)
    : label_(std::move(label)), share_(std::move(share)) {
  if (shown) {
    thread_ = std::thread([this] { draw(); });
  }
}

ProgressBar::~ProgressBar() {
  if (!thread_.joinable()) {
    return;
  }
  {
    const std::lock_guard lock(mutex_);
    is_over_ = true;
  }
  over_.notify_one();
  thread_.join();
}

void ProgressBar::draw() {
  using std::chrono::milliseconds;
  constexpr std::string_view kClearLine = "\r\x1b[K";
  bool drawn = false;
  for (milliseconds wait{1000};; wait = milliseconds{100}) {
    {
      std::unique_lock lock(mutex_);
      if (over_.wait_for(lock, wait, [this] { return is_over_; })) {
        break;
      }
    }
    write_all(STDERR_FILENO, std::string(kClearLine) + progress_line(label_(), share_()));
    drawn = true;
  }
  if (drawn) {
    write_all(STDERR_FILENO, kClearLine);
  }
}

}  // namespace kerf::program
