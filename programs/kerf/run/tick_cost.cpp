#include "programs/kerf/run/tick_cost.hpp"

#include <cmath>

#include <nlohmann/json.hpp>
#include <spdlog/fmt/fmt.h>

#include "machine/simulated_table.hpp"
#include "programs/kerf/io/interrupt.hpp"
#include "programs/kerf/run/real_time_loop.hpp"

namespace kerf::program {

namespace {

// A rosette of short lines, which G64 makes splines of, corners, arcs, helices and a NURBS curve,
// within 60 mm of where it begins.
std::string rosette() {
  std::string text = "G21 G91.1 G90 G17 G64 P0.01 Q0.01 F6000\n";
  constexpr int kLines = 360;
  for (int i = 0; i <= kLines; ++i) {
    const double angle = 6.283185307179586 * i / kLines;
    const double radius_mm = 40.0 + 15.0 * std::cos(5.0 * angle);
    text += fmt::format("G1 X{:.4f} Y{:.4f}\n", radius_mm * std::cos(angle) - 55.0,
                        radius_mm * std::sin(angle));
  }
  text +=
      "G2 X0 Y0 Z2 I-10 J0 P2\n"
      "G1 X10 Y5\nG1 X0 Y10\nG1 X-10 Y5\nG1 X0 Y0\n"
      "G5.2 P1 L4 X0 Y0\nX10 Y20 P1\nX20 Y-20 P2\nX30 Y20 P1\nX40 Y-20 P2\nX50 Y0 P1\nG5.3\n"
      "G0 X0 Y0 Z0\nM2\n";
  return text;
}

class StringFeed final : public TextFeed {
 public:
  explicit StringFeed(std::string_view text) noexcept : text_(text) {}
  tl::expected<TextPiece, std::string> read() override {
    if (is_read_) {
      return TextPiece{};
    }
    is_read_ = true;
    return TextPiece{.state = TextPiece::State::text, .bytes = text_};
  }
  [[nodiscard]] double share_read() const noexcept override { return is_read_ ? 1.0 : 0.0; }

 private:
  std::string_view text_;
  bool is_read_ = false;
};

// One time through the program. What is wrong with it; nothing: it ran.
std::optional<std::string> run_once(std::string_view text, const TickCostOrder& order,
                                    const MachineSettings& settings, TickCost& cost) {
  Controller controller(settings);
  Operator by(controller, true);
  static_cast<void>(by.give(kerf::Command::enable));
  static_cast<void>(by.give(kerf::Command::start));
  ControllerPlanning planning(controller);
  StringFeed feed(text);
  Progress progress;
  Feeder feeder(planning, feed, progress);
  machine::SimulatedTable table(settings.table);
  TickStage ticks({.settings = settings}, table);
  ticks.enable({});
  Recorder recorder;
  const RunOutcome outcome = run_in_real_time({.controller = controller,
                                               .by = by,
                                               .period_s = settings.limits.period_s,
                                               .realtime = order.realtime},
                                              {feeder, ticks, recorder, progress});
  cost.tick_times.add(outcome.tick_times);
  cost.delays.add(outcome.delays);
  cost.not_permitted = outcome.not_permitted;
  if (controller.program()->has_errors()) {
    return controller.program()->diagnostics().front().message;
  }
  if (ticks.fault().kind != machine::DriveFault::none) {
    return "the machine has no room for 60 mm around its origin, or cannot follow";
  }
  return std::nullopt;
}

nlohmann::ordered_json times_of(const TimeHistogram& times) {
  return {{"mean_s", times.mean_s()},
          {"most_s", times.quantile_s(0.999)},
          {"worst_s", times.worst_s()}};
}

std::string times_text(const TimeHistogram& times) {
  return fmt::format("mean {:.1f} us, 99.9 % up to {:.1f} us, the worst {:.1f} us",
                     1e6 * times.mean_s(), 1e6 * times.quantile_s(0.999), 1e6 * times.worst_s());
}

}  // namespace

std::optional<double> TickCost::shortest_period_s() const noexcept {
  constexpr double kLongest_s = 0.1;
  const double needed_s = delays.worst_s() + tick_times.worst_s();
  for (const double decade_s : {1e-5, 1e-4, 1e-3, 1e-2}) {
    for (const double factor : {1.0, 2.0, 5.0}) {
      if (factor * decade_s >= needed_s) {
        return factor * decade_s;
      }
    }
  }
  return kLongest_s >= needed_s ? std::optional(kLongest_s) : std::nullopt;
}

tl::expected<TickCost, std::string> measure_tick_cost(const TickCostOrder& order,
                                                      MachineSettings settings) {
  settings.dialect = Dialect::rs274;
  const std::string text = rosette();
  TickCost cost{.period_s = settings.limits.period_s};
  while (static_cast<double>(cost.tick_times.count()) * cost.period_s < order.measured_s &&
         !stop_requested()) {
    if (const auto problem = run_once(text, order, settings, cost)) {
      return tl::unexpected(*problem);
    }
  }
  return cost;
}

std::string tick_cost_text(const TickCost& cost) {
  std::string text = fmt::format(
      "{} ticks of {:g} ms\n  each took       {}\n  began late by   {}\n", cost.tick_times.count(),
      1e3 * cost.period_s, times_text(cost.tick_times), times_text(cost.delays));
  const auto period_s = cost.shortest_period_s();
  text += period_s
              ? fmt::format("  period          {:g} ms and more: the worst of both fit into it\n",
                            1e3 * *period_s)
              : "  period          none up to 100 ms takes the worst of both\n";
  for (const std::string& what : cost.not_permitted) {
    text += "  not permitted   " + what + "\n";
  }
  return text;
}

std::string tick_cost_json(const TickCost& cost) {
  nlohmann::ordered_json json;
  json["period_s"] = cost.period_s;
  json["ticks"] = cost.tick_times.count();
  json["tick_times"] = times_of(cost.tick_times);
  json["delays"] = times_of(cost.delays);
  const auto period_s = cost.shortest_period_s();
  json["shortest_period_s"] = period_s ? nlohmann::ordered_json(*period_s) : nullptr;
  json["not_permitted"] = cost.not_permitted;
  return json.dump() + "\n";
}

}  // namespace kerf::program
