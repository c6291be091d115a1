#include "programs/kerf/io/progress_bar.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <sys/ioctl.h>
#include <unistd.h>
#include <utility>

#include <spdlog/fmt/fmt.h>

#include "programs/kerf/io/descriptor.hpp"

namespace kerf::program {

namespace {

// Whole seconds, upwards: what is not over is not 0.
std::string left_text(double left_s) {
  constexpr std::int64_t kMinute = 60;
  constexpr std::int64_t kHour = 3600;
  const auto left = static_cast<std::int64_t>(std::ceil(left_s));
  if (left < kMinute) {
    return fmt::format("{} s left", left);
  }
  if (left < kHour) {
    return fmt::format("{} min {:02} s left", left / kMinute, left % kMinute);
  }
  return fmt::format("{} h {:02} min left", left / kHour, left % kHour / kMinute);
}

// Without the last one: some terminals wrap as soon as that is written.
std::size_t columns_of_terminal() noexcept {
  constexpr std::size_t kUnknown = 80;
  winsize size{};
  const bool is_known = ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return (is_known ? size.ws_col : kUnknown) - 1;
}

}  // namespace

std::optional<double> left_s_of(const WorkDone& done) noexcept {
  constexpr double kMinElapsed_s = 2.0;
  constexpr double kMinShare = 0.01;
  constexpr double kMax_s = 1e7;
  if (!(done.elapsed_s >= kMinElapsed_s && done.share >= kMinShare)) {
    return std::nullopt;
  }
  const double left_s = done.elapsed_s * std::max(1.0 / done.share - 1.0, 0.0);
  return left_s <= kMax_s ? std::optional(left_s) : std::nullopt;
}

std::string progress_line(const std::string& label, const ProgressShown& shown,
                          std::size_t columns) {
  constexpr std::size_t kLongestBar = 40;
  constexpr std::size_t kShortestBar = 8;  // a shorter one says nothing
  const double share = std::clamp(shown.share, 0.0, 1.0);
  const std::string figures = fmt::format(" {:3.0f} %{}", std::floor(share * 100.0),
                                          shown.left_s ? ", " + left_text(*shown.left_s) : "");
  const std::size_t taken = label.size() + std::string_view(" []").size() + figures.size();
  std::string bar;
  if (taken + kShortestBar <= columns) {
    const std::size_t width = std::min(kLongestBar, columns - taken);
    const auto full = static_cast<std::size_t>(share * static_cast<double>(width));
    bar = fmt::format(" [{}{}]", std::string(full, '#'), std::string(width - full, ' '));
  }
  return (label + bar + figures).substr(0, columns);
}

bool ProgressBar::has_terminal() noexcept {
  const char* terminal = std::getenv("TERM");
  return ::isatty(STDERR_FILENO) == 1 &&
         (terminal == nullptr || std::string_view(terminal) != "dumb");
}

ProgressBar::ProgressBar(std::function<std::string()> label, std::function<double()> share,
                         bool shown, Left left)
    : label_(std::move(label)), share_(std::move(share)), left_(left) {
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
  const auto began = std::chrono::steady_clock::now();
  bool drawn = false;
  for (milliseconds wait{1000};; wait = milliseconds{100}) {
    {
      std::unique_lock lock(mutex_);
      if (over_.wait_for(lock, wait, [this] { return is_over_; })) {
        break;
      }
    }
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - began;
    ProgressShown shown{.share = share_()};
    if (left_ == Left::estimated) {
      shown.left_s = left_s_of({.elapsed_s = elapsed.count(), .share = shown.share});
    }
    write_all(STDERR_FILENO,
              std::string(kClearLine) + progress_line(label_(), shown, columns_of_terminal()));
    drawn = true;
  }
  if (drawn) {
    write_all(STDERR_FILENO, kClearLine);
  }
}

}  // namespace kerf::program
