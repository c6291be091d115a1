// What an operator is told of a program while it runs: its messages, the codes in force, the time
// that is left.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "kernel/pipeline_observer.hpp"
#include "kernel/time_left.hpp"

namespace kerf {

// Text is read ahead of the motion, by up to a window and more: what belongs to a block is kept
// until the tool has come to it. Of the planning thread.
class ProgramNotes final : public PipelineObserver {
 public:
  struct Settings {
    const lookahead::PlanLimits& limits;  // these two as of TimeLeft
    std::optional<NominalTime> nominal{};
    std::uint64_t blocks_before = 0;  // are not run, and say nothing
  };
  explicit ProgramNotes(const Settings& settings)
      : blocks_before_(settings.blocks_before), time_left_(settings.limits, settings.nominal) {}

  void read(const parser::ProgramReader& reader) override;
  void move(const parser::Move& move) override;
  void rest(const lookahead::RestTime& time) override { time_left_.push_rest(time); }
  void pushed(const lookahead::Block& block) override { time_left_.push(block); }
  void ended() override { time_left_.end(); }

  // The tool has come to this block (parser::Move::block), or to the program's end, which leaves
  // that.
  void reach(std::uint64_t block);
  void reach_end(const parser::ModalState& left);
  [[nodiscard]] bool is_at_end() const noexcept { return is_at_end_; }
  // The tool is about to come to it: what the program says is there before it is.
  // True: it says something.
  bool announce(std::uint64_t block);
  [[nodiscard]] bool has_more_to_say() const noexcept { return !messages_.empty(); }
  void follow(const TimeLeft::ToolPlace& tool) { time_left_.follow(tool); }
  void end_path_at(double path_mm) { time_left_.end_path_at(path_mm); }

  // Those of the blocks that were reached since the last call.
  std::vector<ProgramMessage> take_messages();
  // "G1 G17 G21 ...", after the words of the block that was reached.
  [[nodiscard]] const std::string& codes() const noexcept { return codes_; }
  // "F600 S9000 T1", of the same block.
  [[nodiscard]] const std::string& words() const noexcept { return words_; }
  // After the same words; nothing: there are none yet.
  [[nodiscard]] const std::optional<parser::ModalState>& state() const noexcept { return state_; }
  [[nodiscard]] const TimeLeft& time_left() const noexcept { return time_left_; }

 private:
  struct Ahead {
    std::uint64_t block = 0;
    parser::ModalState state{};
  };
  void tell_state();

  std::uint64_t blocks_before_;
  std::deque<parser::NumberedMessage> messages_;
  std::vector<ProgramMessage> reached_messages_;
  parser::ModalState read_state_;
  std::deque<Ahead> ahead_;
  std::optional<parser::ModalState> state_{};
  bool is_at_end_ = false;
  std::string codes_;
  std::string words_;
  TimeLeft time_left_;
};

}  // namespace kerf
