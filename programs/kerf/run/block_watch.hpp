// When the planned motion of one block of a program begins and how long it lasts.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "interp/motion.hpp"
#include "kernel/pipeline_observer.hpp"
#include "parser/flow/block_watcher.hpp"

namespace kerf::program {

// Called for everything that is read and planned, in program order. Planned motion lags behind
// reading by up to one window; motion is known by the block of the program's run that it belongs
// to, a rest by counting rests on both sides. Cutter compensation holds moves back before that; so
// they are counted from the block's own or the next.
class BlockWatch : public PipelineObserver, public parser::BlockWatcher {
 public:
  struct Settings {
    std::uint32_t line = 0;
    double period_s = 0.001;
  };
  explicit BlockWatch(const Settings& settings) noexcept
      : line_(settings.line), period_s_(settings.period_s) {}

  void about_to_run(const parser::UpcomingBlock& block) override;
  void move(const parser::Move& move) override;
  void rest(const lookahead::RestTime& /*time*/) override { ++rests_pushed_; }
  // The lines of a curve come with its first phase.
  void planned(const lookahead::Outbox& outbox) override;

  // The block's text and the modes in force before it; nothing where the line was never run.
  [[nodiscard]] const std::optional<parser::WatchedBlock>& block() const noexcept { return block_; }
  // From the program's start; nothing where nothing moves at the block or after it.
  [[nodiscard]] std::optional<double> begin_s() const noexcept { return begin_s_; }
  // Of the block's own motion or dwell; 0 where it has none.
  [[nodiscard]] double duration_s() const noexcept { return end_s_ - begin_s_.value_or(end_s_); }

 private:
  // A stretch of motion or a rest that belongs to one line.
  struct Part {
    std::uint32_t line = 0;
    std::uint64_t run_block = 0;
    double begin_s = 0.0;
    double end_s = 0.0;
  };
  void planned(const interp::Phase& phase);
  void add(const Part& part);
  [[nodiscard]] double seconds(const interp::TickTime& time) const noexcept {
    return static_cast<double>(time.tick) * period_s_ + time.offset_s;
  }

  std::uint32_t line_;
  double period_s_;
  std::optional<parser::WatchedBlock> block_;
  // Of the first move that is planned at the block or after it.
  struct First {
    std::uint64_t run_block = 0;
    std::uint64_t rests_before = 0;
  };
  std::optional<First> first_;
  // Where the line runs for the second time.
  struct Again {
    std::uint64_t blocks_before = 0;
    std::uint64_t rests_before = 0;
  };
  std::optional<Again> again_;
  std::uint64_t rests_pushed_ = 0;
  std::uint64_t rests_planned_ = 0;
  std::deque<interp::LineChange> changes_;  // that lie ahead
  std::optional<double> begin_s_;
  double end_s_ = 0.0;
  bool over_ = false;
};

}  // namespace kerf::program
