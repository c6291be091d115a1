// Blocks to moves: keeps the modal state and does each block's words in the order of RS274/NGC.
#pragma once

#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "parser/compensation/cutter_compensation.hpp"
#include "parser/curves/curve_reader.hpp"
#include "parser/cycles/drill_cycle.hpp"
#include "parser/cycles/probe.hpp"
#include "parser/interpreter/feed.hpp"
#include "parser/interpreter/saved_modes.hpp"
#include "parser/modal/program_memory.hpp"
#include "parser/spindle_io/spindle.hpp"

namespace kerf::parser {

// The order within a block: units and feed mode; F; S; T; inputs and outputs; M6; spindle; saved
// modes; coolant; overrides; dwell; plane, distance, tool length, work offset, path; G10, G28, G52
// and their like or motion; stop. It is that of LinuxCNC but for units, which come before F. A
// block is checked for words that nothing in it uses before anything is done.
//
// After an error the block's plain effects (codes of motion, plane, units, distance; end point) are
// still taken over, so that one mistake is not reported again by the blocks after it.
//
// Each code is done by its unit (offsets/, spindle_io/, cycles/, curves/, compensation/,
// dialects/), which gets the block and the modal state. This class decides which unit comes when.
class Interpreter {
 public:
  Interpreter(ProgramMemory start, diagnostics::DiagnosticList& diagnostics);

  // `complete` is false where the grammar stopped inside the line.
  void run(const BlockWords& block, std::uint32_t line, bool complete);
  // X, Y, Z and those auxiliary axes that the machine has.
  [[nodiscard]] Letters axis_letters() const { return kAxisLetters | memory_.machine.extra_axes; }
  // The line that is about to be read: what it works out may ask for its number.
  void enter_line(std::uint32_t line) { memory_.line = line; }
  // The blocks that follow are of that place's file, called from there.
  void enter_file(const diagnostics::SourcePosition& place) {
    file_ = place;
    reported_line_ = 0;
  }
  // Of the file that is read: of `at` line and column count.
  [[nodiscard]] diagnostics::SourcePosition in_file(diagnostics::SourcePosition at) const {
    at.file = file_.file;
    at.calling_line = file_.calling_line;
    return at;
  }
  // Says that no block will follow: a curve that is still open is an error.
  void end(std::uint32_t last_line, std::string_view where);

  // A subprogram begins and ends, for M70 to M73.
  void enter_subprogram();
  void leave_subprogram();

  [[nodiscard]] const ModalState& state() const { return memory_.state; }
  [[nodiscard]] std::uint64_t blocks_run() const { return blocks_run_; }
  // A curve of several blocks has begun and is not complete.
  [[nodiscard]] bool in_curve() const { return curves_.open(); }
  // What parameters show, good as long as the interpreter is.
  [[nodiscard]] ProgramMemory& memory() { return memory_; }
  [[nodiscard]] const ProgramMemory& memory() const { return memory_; }
  [[nodiscard]] MoveQueue& moves() { return moves_; }
  [[nodiscard]] bool program_ended() const { return program_ended_; }
  // Returns what the block has raised, and clears it.
  MacroSignal take_signal() { return std::exchange(memory_.state.signal, {}); }
  // Of the last block that ran, which asked.
  void take_answer(const MachineQuestion& question, const MachineAnswer& answer);
  // Ends the program as M2 does.
  void end_program(const diagnostics::SourcePosition& source);

 private:
  // interpreter.cpp
  Done refuse(const RunningBlock& at);
  Done execute(const RunningBlock& at);
  Done set_feed_speed_and_tool(const RunningBlock& at);
  Done do_words(const RunningBlock& at);
  void report(std::uint32_t line, const diagnostics::Fault& fault);
  bool leaves_skipped_curve(const RunningBlock& at, bool complete);
  bool belongs_to_curve(const RunningBlock& at);
  void take_fault(const RunningBlock& at, const diagnostics::Fault& fault);
  void tell_contour_faults();
  void compensate_moves(const diagnostics::SourcePosition& source);
  void bring_back(const MoveSink& at, const ModalState& saved);
  void keep_contour_in_place(const MoveSink& at, const ModalState& before);
  void bring_back_compensation(const MoveSink& at, const ModalState& saved);

  // recovery.cpp
  void recover(const RunningBlock& at);
  void recover_code(const RunningBlock& at, double g);
  void recover_motion(const RunningBlock& at, Tenths code);

  // interpreter_modes.cpp
  void set_units_and_feed_mode(const BlockCodes& codes);
  Done switch_machine(const RunningBlock& at);
  Done save_modes(const RunningBlock& at);
  Done set_modes(const RunningBlock& at);
  Done set_compensation(const RunningBlock& at);
  Done set_coordinates(const RunningBlock& at);
  Done do_once(const RunningBlock& at);
  Done set_data(const RunningBlock& at);
  Done go_to_reference_point(const RunningBlock& at);

  // interpreter_motion.cpp
  Done move(const RunningBlock& at, Group axis_taker);
  Done do_motion(const RunningBlock& at);
  Done rapid_to_words(const RunningBlock& at);
  Done straight_move(const RunningBlock& at);
  struct Straight {
    Point end_mm{};
    bool rapid = false;
    double feedrate_mm_s = 0.0;
  };
  void push_line(const RunningBlock& at, const Straight& line);
  Done straight_move_with_auxiliary(const RunningBlock& at, const Point& end_mm);
  Done arc_move(const RunningBlock& at);
  Done begin_curve(const RunningBlock& at);
  Done spline(const RunningBlock& at);
  Done drill(const RunningBlock& at);
  struct CycleFeed {
    double feedrate_mm_s = 0.0;
    bool rapids_stop = true;  // at a feed override of 0; the feed of a tap does not
  };
  void push_cycle_step(const RunningBlock& at, const CycleStep& step, const CycleFeed& feed);
  Done probe(const RunningBlock& at);

  ProgramMemory memory_;
  const DialectRules* rules_;
  SavedModes saved_modes_;
  MoveQueue moves_;
  diagnostics::DiagnosticList* diagnostics_;
  CutterCompensation compensation_;
  CurveReader curves_;
  Feed feed_;
  SpindleDrive spindle_;
  std::vector<CycleStep> cycle_steps_;  // of the running block
  BlockCodes codes_;                    // the same
  AskedProbe asked_;                    // by the last G38
  std::uint64_t blocks_run_ = 0;
  std::uint32_t column_ = 0;          // of the last block that ran
  std::uint32_t reported_line_ = 0;   // one error per block
  diagnostics::SourcePosition file_;  // whose blocks run; its line counts for nothing
  bool program_ended_ = false;
};

}  // namespace kerf::parser
