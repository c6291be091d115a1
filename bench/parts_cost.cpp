#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <string_view>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <kerf/check.hpp>
#include <kerf/kernel.hpp>

#include "bench/part_run.hpp"
#include "bench/parts.hpp"
#include "interp/setpoint.hpp"

namespace kerf::bench {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::int64_t kMillion = 1'000'000;
constexpr double kMax_s = 10.0;
constexpr double kMaxMiB = 128.0;
constexpr double kMaxGrowth = 10.5;

// The flower's lines as text, in pieces as from a file. The time that making them takes is kept.
class FlowerText {
 public:
  explicit FlowerText(std::int64_t lines) : lines_left_(lines) {}

  [[nodiscard]] Point start_mm() const { return Flower(0.1).here(); }
  // Empty at the end.
  std::string_view next() {
    constexpr std::size_t kPiece = std::size_t{64} * 1024;
    const Clock::time_point began = Clock::now();
    piece_.clear();
    if (!begun_) {
      begun_ = true;
      piece_ = "G21 G90 G17 G94 G64 P0.01 Q0.01 F6000\n";
    }
    while (piece_.size() < kPiece && lines_left_ > 0) {
      flower_.advance();
      const Point point = flower_.here();
      std::array<char, 80> line{};
      const int length = std::snprintf(line.data(), line.size(), "G1 X%.4f Y%.4f Z%.4f\n", point[0],
                                       point[1], point[2]);
      piece_.append(line.data(), static_cast<std::size_t>(length));
      if (--lines_left_ == 0) {
        piece_ += "M2\n";
      }
    }
    made_ += Clock::now() - began;
    return piece_;
  }
  [[nodiscard]] double making_s() const { return made_.count(); }

 private:
  Flower flower_{0.1};
  std::int64_t lines_left_;
  bool begun_ = false;
  std::string piece_;
  std::chrono::duration<double> made_{};
};

struct Cost {
  double check_s = 0.0;
  double run_s = 0.0;
  std::int64_t ticks = 0;
  double peak_mib = 0.0;
};

double check(const MachineSettings& settings, std::int64_t lines) {
  FlowerText text(lines);
  const Clock::time_point began = Clock::now();
  const CheckReport report =
      check_program([&text] { return text.next(); }, settings, {.start_mm = text.start_mm()}, {});
  if (report.has_errors()) {
    throw std::runtime_error("the flower is refused");
  }
  return std::chrono::duration<double>(Clock::now() - began).count() - text.making_s();
}

Cost dry_run(std::int64_t lines, profiles::ProfileKind profile) {
  const MachineSettings settings = machine_with({.acceleration_mm_s2 = 500.0, .jerk_mm_s3 = 5e4});
  Cost cost{.check_s = check(settings, lines)};
  FlowerText text(lines);
  Kernel kernel(settings, {.profile = profiles::Profile(profile),
                           .one_thread = true,  // as `kerf dry-run`: no way to rest is kept ready
                           .start_mm = text.start_mm()});
  const Clock::time_point began = Clock::now();
  auto status = interp::TickStatus::running;
  for (interp::Setpoint setpoint;
       status != interp::TickStatus::finished && status != interp::TickStatus::failed;) {
    while (kernel.plan()) {
      const std::string_view piece = text.next();
      if (piece.empty()) {
        kernel.finish();
      } else {
        kernel.feed(piece);
      }
    }
    status = kernel.tick(setpoint);
    ++cost.ticks;
  }
  cost.run_s = std::chrono::duration<double>(Clock::now() - began).count() - text.making_s();
  if (kernel.has_errors()) {
    throw std::runtime_error("the flower is refused");
  }
  return cost;
}

// In a process of its own, whose memory is the run's.
Cost dry_run_alone(std::int64_t lines, profiles::ProfileKind profile) {
  std::array<int, 2> ends{};
  if (::pipe(ends.data()) != 0) {
    throw std::runtime_error("no pipe");
  }
  std::fflush(stdout);
  const pid_t child = ::fork();
  if (child == 0) {
    const Cost cost = dry_run(lines, profile);
    const bool sent = ::write(ends[1], &cost, sizeof cost) == sizeof cost;
    std::_Exit(sent ? 0 : 1);
  }
  ::close(ends[1]);
  Cost cost;
  const bool received = child > 0 && ::read(ends[0], &cost, sizeof cost) == sizeof cost;
  ::close(ends[0]);
  int status = 0;
  rusage usage{};
  if (child > 0) {
    ::wait4(child, &status, 0, &usage);
  }
  if (!received || status != 0) {
    throw std::runtime_error("a dry run failed");
  }
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-union-access): a member of rusage is one.
  cost.peak_mib = static_cast<double>(usage.ru_maxrss) / 1024.0;
  return cost;
}

bool print_row(std::int64_t lines, const Cost& cost, bool met) {
  const double all_s = cost.check_s + cost.run_s;
  std::printf("| %lld | %.2f | %.2f | %.2f | %lld | %.0f | %.1f | %s |\n",
              static_cast<long long>(lines), cost.check_s, cost.run_s, all_s,
              static_cast<long long>(cost.ticks), static_cast<double>(lines) / all_s, cost.peak_mib,
              met ? "met" : "MISSED");
  std::fflush(stdout);
  return met;
}

}  // namespace

bool parts_cost(const PartsOrder& order) {
  if (!order.only.empty() && order.only != "cost") {
    return true;
  }
  const std::int64_t lines = order.quick ? kMillion / 10 : kMillion;
  const double max_s = order.quick ? kMax_s / 10.0 : kMax_s;
  std::printf(
      "A dry run of the flower's lines of 0.1 mm (F6000, a 500, J 50000, G64 P0.01 Q0.01) with "
      "ticks to nowhere; targets: %g s and %g MiB for %lld lines, %g times that for 10 times the "
      "lines.\n\n"
      "| lines | check [s] | run [s] | both [s] | ticks | lines/s | peak memory [MiB] | |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- |\n",
      max_s, kMaxMiB, static_cast<long long>(lines), kMaxGrowth);
  const auto seconds_of = [](const Cost& cost) { return cost.check_s + cost.run_s; };
  const Cost once = dry_run_alone(lines, order.profile);
  bool met = print_row(lines, once, seconds_of(once) <= max_s && once.peak_mib <= kMaxMiB);
  if (order.with_long) {
    const Cost ten = dry_run_alone(10 * lines, order.profile);
    const bool held = seconds_of(ten) <= kMaxGrowth * seconds_of(once) && ten.peak_mib <= kMaxMiB;
    met = print_row(10 * lines, ten, held) && met;
  }
  std::printf("\n");
  return met;
}

}  // namespace kerf::bench
