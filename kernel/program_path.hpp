// Turns a program's text into the path that is run: segments and pauses, and diagnostics.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string_view>
#include <vector>

#include <kerf/kernel.hpp>

#include "kernel/pipeline_observer.hpp"
#include "kernel/start_in_middle.hpp"
#include "kernel/tick_judge.hpp"
#include "kernel/travel_check.hpp"
#include "kernel/wait_check.hpp"
#include "parser/program_reader.hpp"
#include "smoothing/smoother.hpp"

namespace kerf {

class ProgramPath {
 public:
  using Output = smoothing::Smoother::Output;
  enum class Next : std::uint8_t { output, wants_text, ended };

  struct Order {
    parser::BlockWatcher* watcher = nullptr;  // ReaderOptions::watcher
    bool asks_machine = false;                // at G38 and M66 next() wants text until answer()
    // In G61 each line comes out by itself; so it is up to a start in the program, which may be
    // any.
    bool keeps_exact_lines_apart = false;
    // Moves come out unsmoothed, including those after an error and those before a start.
    bool as_programmed = false;
    PipelineObserver* observer =
        nullptr;  // for the path that is run; not called with as_programmed
  };

  ProgramPath(const MachineSettings& settings, const KernelOptions& options, const Order& order);

  // After the program's end or an error nothing is read.
  void feed(std::string_view text) {
    if (!ended_) {
      reader_.feed(text);
    }
  }
  void finish() {
    reader_.finish();
    has_all_text_ = true;
  }

  // Of text that is not read yet.
  void set_optional_stop(bool on) { waits_.set_optional_stop(on); }
  void keep_blocks_apart(bool on) noexcept { smoother_.keep_blocks_apart(on); }
  // Its length may lead what is read from now on beyond the travel, which is checked therefore.
  void set_tool(const Tool& tool) {
    reader_.set_tool(tool);
    checks_travel_ = true;
  }
  // Kernel::start_counts_on_tools().
  [[nodiscard]] bool start_counts_on_tools() const {
    return (start_ || !way_to_start_.empty()) && reader_.modal_state().tool_length_active;
  }
  void set_block_delete(const BlockDelete& switches) { reader_.set_block_delete(switches); }

  // The path ends before the first block with an error.
  // Order::as_programmed: each output is a move.
  Next next(Output& output);
  // Of the machine. Precondition: the last output was the event that asks it.
  void answer(const parser::MachineAnswer& answer);
  // No more of the program is run, whatever text follows.
  [[nodiscard]] bool at_end() const { return reader_.at_end(); }
  // Releases what waits for its successor, as if none came.
  void flush() { smoother_.flush(); }
  // The segment that next() gave cannot be run: the path has ended before it, with this error.
  void cut(const diagnostics::SourcePosition& source, const smoothing::PathError& error,
           const diagnostics::ErrorPage& page);

  // Runs nothing, for a reason that is not in the text.
  void refuse(diagnostics::Diagnostic fault);

  // The programmed end of what was read so far; nothing if the program has an error.
  [[nodiscard]] std::optional<PlaceOfTool> programmed_end() const;
  // Of the move read last, or of the segment that was cut.
  [[nodiscard]] std::uint32_t line() const noexcept { return source_.program_line(); }
  [[nodiscard]] bool has_errors() const { return failed_ || reader_.has_errors(); }
  // The error is a move that leaves the travel.
  [[nodiscard]] bool left_travel() const noexcept { return left_travel_; }
  [[nodiscard]] const std::vector<diagnostics::Diagnostic>& diagnostics() const {
    return failed_ ? all_diagnostics_ : reader_.diagnostics();
  }
  [[nodiscard]] const parser::ProgramReader& reader() const noexcept { return reader_; }
  // Under which motion was read, in the order of their first moves, the first kPathControls.
  static constexpr std::size_t kPathControls = 8;
  [[nodiscard]] const std::vector<PathControlUse>& path_controls() const noexcept {
    return path_controls_;
  }
  [[nodiscard]] smoothing::PathDeviations deviations() const noexcept {
    return smoother_.deviations();
  }

 private:
  // The next move into the smoother. False: there is no more text.
  bool read_move();
  void note_path_control(const parser::Move& move);
  // True: the path ends before it.
  bool refuses(const parser::Move& move);
  void fail(const smoothing::PathError& error, const diagnostics::ErrorPage& page);
  // Moves that the smoother still holds are run.
  void end();
  // False: there is none now.
  bool next_to_run(Output& output);
  Next next_as_programmed(Output& output);

  Order order_;
  bool has_all_text_ = false;

  parser::ProgramReader reader_;
  TravelCheck travel_;
  bool checks_travel_;
  WaitCheck waits_;
  smoothing::Smoother smoother_;
  std::optional<StartInMiddle> start_;  // until its block comes
  std::deque<Output> way_to_start_;     // and the first output after it
  bool way_asks_ = false;               // the machine, which has not answered
  std::vector<PathControlUse> path_controls_;
  PlaceOfTool end_{};                   // of the move read last
  diagnostics::SourcePosition source_;  // of the move read last, or of the segment that was cut
  bool ended_ = false;                  // only what the smoother still holds will follow
  bool cut_ = false;                    // that is not run either
  bool failed_ = false;
  bool left_travel_ = false;
  std::vector<diagnostics::Diagnostic> all_diagnostics_;  // once it failed
};

}  // namespace kerf
