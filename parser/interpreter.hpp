// Blocks to moves: keeps the modal state and does each block's words in the order of RS274/NGC.
#pragma once

#include <cstdint>
#include <string>

#include "parser/block.hpp"
#include "parser/codes.hpp"
#include "parser/curve_block.hpp"
#include "parser/diagnostic_list.hpp"
#include "parser/fault.hpp"
#include "parser/modal_state.hpp"
#include "parser/move_queue.hpp"
#include "parser/nurbs_collector.hpp"
#include "parser/uniform_collector.hpp"

namespace kerf::parser {

// The order within a block: units, feed mode and modes of reading; F; S; T; M6; spindle; coolant;
// dwell; motion; stop. A block is checked for words that nothing in it uses before anything is
// done.
//
// After an error the block's plain effects (codes of motion, plane, units, distance; end point) are
// still taken over, so that one mistake is not reported again by the blocks behind it.
class Interpreter {
 public:
  Interpreter(const Point& start_mm, DiagnosticList& diagnostics);

  // `complete` is false where the grammar stopped inside the line.
  void run(const Block& block, std::uint32_t line, bool complete);
  // The blocks that follow are of this file: the index in their moves' SourcePosition.
  void enter_file(std::uint16_t file) {
    file_ = file;
    reported_line_ = 0;
  }
  // Says that no block will follow: a curve that is still open is an error.
  void end(std::uint32_t last_line, std::string_view where);

  [[nodiscard]] const ModalState& state() const { return state_; }
  [[nodiscard]] MoveQueue& moves() { return moves_; }
  [[nodiscard]] bool program_ended() const { return program_ended_; }
  // Ends the program as M2 does.
  void end_program(SourcePosition source);

 private:
  // interpreter.cpp
  bool execute();
  bool check_words();
  bool check_axis_users();
  bool explain_idle_axes();
  bool explain_unused(const Word& word);
  void recover();
  void recover_code(double g);
  bool fail(std::uint32_t offset, std::string message);
  bool fail(std::uint32_t offset, const ErrorPage& page, std::string message);
  void report(const Fault& fault);
  void warn(std::uint32_t offset, std::string message);
  void warn(std::uint32_t offset, const ErrorPage& page, std::string message);
  Move& push_move();

  // interpreter_modes.cpp
  void set_modes();
  void set_units(Units units);
  void set_feed_mode(FeedMode mode);
  bool set_path_mode();
  bool set_feed();
  bool set_speed_and_tool();
  void start_spindle();
  void switch_coolant();
  bool dwell();
  void stop();
  void push_event(EventKind kind, double value);
  bool cutting_feedrate(double length_mm, double& feedrate_mm_s);

  // interpreter_motion.cpp
  void set_motion(Tenths code);
  bool move();
  bool straight_move();
  bool arc_move();
  bool check_machine_coordinates();
  [[nodiscard]] CurveBlock curve_block() const { return {*block_, codes_, state_, line_}; }
  [[nodiscard]] std::uint32_t motion_offset() const;

  // interpreter_curves.cpp
  [[nodiscard]] bool curve_open() const { return nurbs_.active() || uniform_.active(); }
  [[nodiscard]] bool begins_curve() const;
  bool begin_curve();
  bool continue_curve();
  bool reports_open_curve();
  void abandon_curve();
  bool leave_skipped_curve();
  bool deliver_curve(NurbsMove curve, std::string_view name);
  bool curve_feed();

  // interpreter_splines.cpp
  bool cubic_spline();
  bool quadratic_spline();
  bool is_high_speed_mode() const;
  bool check_spline_axes(std::string_view name);
  bool deliver_spline(NurbsMove curve, std::string_view name);

  ModalState state_;
  MoveQueue moves_;
  DiagnosticList* diagnostics_;
  NurbsCollector nurbs_;
  UniformCollector uniform_;
  SourcePosition curve_source_;
  double curve_feedrate_mm_s_ = 0.0;
  Tenths skipped_curve_ = kNoCode;  // the code of a curve with an error whose blocks still come

  const Block* block_ = nullptr;  // of the running block
  BlockCodes codes_;
  Fault fault_;
  std::uint32_t line_ = 0;
  std::uint16_t file_ = 0;
  std::uint32_t reported_line_ = 0;  // one error per block
  bool no_feed_reported_ = false;
  bool program_ended_ = false;
};

}  // namespace kerf::parser
