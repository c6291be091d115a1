// When the planned motion of one block of a program begins and how long it lasts.
#pragma once

#include <cstdint>
#include <optional>

#include "interp/motion.hpp"
#include "parser/program_reader.hpp"

namespace kerf::program {

// Told of everything that is read and planned, in order. What is planned comes later than what is
// read, by up to a window; so the block is found by counting curves and rests on both sides. Cutter
// compensation holds moves back before that; so they are counted from the block's own or the next.
class BlockWatch {
 public:
  struct Settings {
    std::uint32_t line = 0;
    double period_s = 0.001;
  };
  explicit BlockWatch(const Settings& settings) noexcept
      : line_(settings.line), period_s_(settings.period_s) {}

  [[nodiscard]] std::uint32_t line() const noexcept { return line_; }

  // After each read.
  void read(const parser::ProgramReader& reader);
  // The move that was read is to be planned.
  void moves(const parser::Move& move) noexcept;
  // The move became so many curves, or one rest.
  void pushed(std::uint64_t items) noexcept { items_pushed_ += items; }
  void planned(const interp::Phase& phase);

  // The block's text and the modes in force before it; nothing where the line was never run.
  [[nodiscard]] const std::optional<parser::WatchedBlock>& block() const noexcept { return block_; }
  // From the program's start; nothing where nothing moves at the block or after it.
  [[nodiscard]] std::optional<double> begin_s() const noexcept { return begin_s_; }
  // Of the block's own motion or dwell; 0 where it has none.
  [[nodiscard]] double duration_s() const noexcept { return end_s_ - begin_s_.value_or(end_s_); }

 private:
  [[nodiscard]] double seconds(const interp::TickTime& time) const noexcept {
    return static_cast<double>(time.tick) * period_s_ + time.offset_s;
  }

  std::uint32_t line_;
  double period_s_;
  std::optional<parser::WatchedBlock> block_;
  std::optional<std::uint64_t> items_before_;
  std::uint64_t items_pushed_ = 0;
  std::uint64_t items_planned_ = 0;
  std::uint64_t curve_ = 0;  // of the latest phase that moves
  std::optional<double> begin_s_;
  double end_s_ = 0.0;
  bool over_ = false;
};

}  // namespace kerf::program
