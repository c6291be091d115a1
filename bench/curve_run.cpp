#include "bench/curve_run.hpp"

#include <chrono>
#include <memory>
#include <stdexcept>
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

CurveRun from_rest(const Block& block, const lookahead::PlanLimits& limits,
                   const profiles::Profile& profile) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point began = Clock::now();
  lookahead::Planner planner({.limits = limits, .profile = profile});
  planner.push(block);
  planner.finish(0);
  lookahead::Outbox outbox;
  while (planner.emit(outbox)) {
  }
  const std::chrono::duration<double> planning = Clock::now() - began;
  const auto ring = std::make_unique<interp::MotionQueue>();
  interp::MotionQueue& queue = *ring;
  const curves::Position start = curves::derivatives_at(block.curve, 0.0).position_mm;
  interp::Interpolator interpolator(queue, limits.period_s, start);
  TickJudge judge({.limits = limits});
  std::int64_t ticks = -1;
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
    Setpoint setpoint;
    status = interpolator.next(setpoint);
    judge.add(setpoint, interpolator.chord_error_mm());
    ++ticks;
  }
  return {.time_s = static_cast<double>(ticks) * limits.period_s,
          .planning_s = planning.count(),
          .path = judge.path(),
          .axes = judge.axes(),
          .chord_error_mm = judge.chord_error_mm()};
}

}  // namespace kerf::bench
