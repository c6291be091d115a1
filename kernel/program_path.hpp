// The program as the path that is run: text in, segments of the path and pauses on it out, with
// what is wrong with the program.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include <kerf/kernel.hpp>

#include "kernel/pipeline_observer.hpp"
#include "kernel/tick_judge.hpp"
#include "kernel/travel_check.hpp"
#include "parser/program_reader.hpp"
#include "smoothing/smoother.hpp"

namespace kerf {

class ProgramPath {
 public:
  using Output = smoothing::Smoother::Output;
  enum class Next : std::uint8_t { output, wants_text, ended };

  struct Order {
    std::uint32_t watched_line = 0;  // whose block the reader shows; 0: none
    bool as_programmed = false;      // the moves come out as they are, those behind an error too
    PipelineObserver* observer = nullptr;  // of the path that is run; not told as programmed
  };

  ProgramPath(const MachineSettings& settings, const KernelOptions& options, const Order& order);

  void feed(std::string_view text) { reader_.feed(text); }
  void finish() {
    reader_.finish();
    has_all_text_ = true;
  }

  // At a block with an error the path ends, where the program is right so far.
  // Order::as_programmed: each output is a move.
  Next next(Output& output);
  // No more of the program is run, whatever text follows.
  [[nodiscard]] bool at_end() const { return reader_.at_end(); }
  // What is held back for the sake of what follows comes out without it.
  void flush() { smoother_.flush(); }
  // The part that next() gave cannot be run: the path has ended before it, with this error.
  void cut(const diagnostics::SourcePosition& source, const smoothing::PathError& error,
           const diagnostics::ErrorPage& page);

  // Nothing is run, for a reason that is not in the text.
  void refuse(diagnostics::Diagnostic fault);

  // Where the program leads the tool, so far as it was read. Nothing: it has an error.
  [[nodiscard]] std::optional<PlaceOfTool> programmed_end() const;
  // Of the move read last, or of the segment that was cut.
  [[nodiscard]] std::uint32_t line() const noexcept { return source_.line; }
  [[nodiscard]] bool has_errors() const { return failed_ || reader_.has_errors(); }
  // The error is a move that leaves the travel.
  [[nodiscard]] bool left_travel() const noexcept { return left_travel_; }
  [[nodiscard]] const std::vector<diagnostics::Diagnostic>& diagnostics() const {
    return failed_ ? all_diagnostics_ : reader_.diagnostics();
  }
  [[nodiscard]] const parser::ProgramReader& reader() const noexcept { return reader_; }
  [[nodiscard]] smoothing::PathDeviations deviations() const noexcept {
    return smoother_.deviations();
  }

 private:
  // The next move into the smoother. False: there is no more text.
  bool read_move();
  void fail(const smoothing::PathError& error, const diagnostics::ErrorPage& page);
  // What is held back still runs.
  void end();
  Next next_as_programmed(Output& output);

  Order order_;
  bool has_all_text_ = false;

  parser::ProgramReader reader_;
  std::optional<TravelCheck> travel_;
  smoothing::Smoother smoother_;
  PlaceOfTool end_{};                   // of the move read last
  diagnostics::SourcePosition source_;  // of the move read last, or of the segment that was cut
  bool ended_ = false;                  // what the smoother still holds is all that follows
  bool cut_ = false;                    // and none of that is run
  bool failed_ = false;
  bool left_travel_ = false;
  std::vector<diagnostics::Diagnostic> all_diagnostics_;  // once it failed
};

}  // namespace kerf
