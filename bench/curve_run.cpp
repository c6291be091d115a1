#include "bench/curve_run.hpp"

#include <chrono>
#include <memory>
#include <stdexcept>
#include <utility>
#include <variant>

#include "bench/program_text.hpp"
#include "interp/interpolator.hpp"
#include "lookahead/path/block_builder.hpp"
#include "lookahead/planner.hpp"
#include "parser/program_reader.hpp"

namespace kerf::bench {

using lookahead::Block;

MachineSettings machine(const std::string& name) {
  auto settings = parse_machine_file(source_file("programs/machines/" + name));
  if (!settings) {
    throw std::runtime_error(name + ": " + settings.error().front().message);
  }
  return *settings;
}

std::vector<parser::Move> moves_of(const std::string& program) {
  parser::ProgramReader reader;
  reader.feed(source_file("programs/" + program));
  reader.finish();
  std::vector<parser::Move> moves;
  for (parser::Move move; reader.next(move);) {
    moves.push_back(move);
  }
  return moves;
}

Block curve_block(const std::string& program, const lookahead::PlanLimits& limits,
                  std::optional<double> feedrate_mm_s) {
  for (parser::Move move : moves_of(program)) {
    move.feedrate_mm_s = feedrate_mm_s.value_or(move.feedrate_mm_s);
    std::vector<Block> blocks;
    if (std::holds_alternative<parser::NurbsMove>(move.shape) &&
        lookahead::append_blocks(move, limits, blocks)) {
      return blocks.front();
    }
  }
  throw std::runtime_error(program + " holds no curve");
}

curves::NurbsData curve_data(const std::string& program) {
  for (const parser::Move& move : moves_of(program)) {
    if (const auto* nurbs = std::get_if<parser::NurbsMove>(&move.shape)) {
      curves::NurbsData data{.degree = nurbs->degree, .points = {}, .knots = nurbs->knots};
      for (const parser::NurbsPoint& point : nurbs->points) {
        data.points.push_back({.position_mm = point.position_mm, .weight = point.weight});
      }
      return data;
    }
  }
  throw std::runtime_error(program + " holds no curve");
}

namespace {

std::vector<TickOfRun> ticks_of(const lookahead::Outbox& outbox, const curves::Position& start_mm,
                                double period_s) {
  const auto ring = std::make_unique<interp::MotionQueue>();
  interp::MotionQueue& queue = *ring;
  interp::Interpolator interpolator(queue, period_s, start_mm);
  std::vector<TickOfRun> ticks;
  std::size_t pieces = 0;
  std::size_t phases = 0;
  for (TickStatus status = TickStatus::running; status == TickStatus::running;) {
    while (pieces < outbox.pieces.size() && queue.push(outbox.pieces[pieces])) {
      ++pieces;
    }
    while (phases < outbox.phases.size() && queue.push(outbox.phases[phases])) {
      ++phases;
    }
    queue.commit();
    TickOfRun tick;
    status = interpolator.next(tick.setpoint);
    tick.chord_error_mm = interpolator.chord_error_mm();
    ticks.push_back(tick);
  }
  return ticks;
}

}  // namespace

PlannedRun plan_of(const std::vector<Block>& blocks, const lookahead::PlanLimits& limits,
                   const profiles::Profile& profile) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point began = Clock::now();
  lookahead::Planner planner({.limits = limits, .profile = profile});
  for (const Block& block : blocks) {
    planner.push(block);
  }
  planner.finish(0);
  lookahead::Outbox outbox;
  while (planner.emit(outbox)) {
  }
  const std::chrono::duration<double> planning = Clock::now() - began;
  const curves::Position start = curves::derivatives_at(blocks.front().curve, 0.0).position_mm;
  return {.planning_s = planning.count(),
          .ticks = ticks_of(outbox, start, limits.period_s),
          .phases = std::move(outbox.phases)};
}

CurveRun from_rest(const Block& block, const lookahead::PlanLimits& limits,
                   const profiles::Profile& profile) {
  const PlannedRun run = plan_of({block}, limits, profile);
  TickJudge judge({.limits = limits});
  for (const TickOfRun& tick : run.ticks) {
    judge.add(tick.setpoint, tick.chord_error_mm);
  }
  return {.time_s = static_cast<double>(run.ticks.size() - 1) * limits.period_s,
          .planning_s = run.planning_s,
          .path = judge.path(),
          .axes = judge.axes(),
          .chord_error_mm = judge.chord_error_mm()};
}

}  // namespace kerf::bench
