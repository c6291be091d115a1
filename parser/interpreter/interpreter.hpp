// Blocks to moves: keeps the modal state and does each block's words in the order of RS274/NGC.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "parser/curves/curve_block.hpp"
#include "parser/cycles/drill_cycle.hpp"
#include "parser/interpreter/interpreter_memory.hpp"

namespace kerf::parser {

// The order within a block: units and feed mode; F; S; T; inputs and outputs; M6; spindle; saved
// modes; coolant; overrides; dwell; plane, distance, tool length, work offset, path; G10, G28, G52
// and their like or motion; stop. It is that of LinuxCNC but for units, which come before F. A
// block is checked for words that nothing in it uses before anything is done.
//
// After an error the block's plain effects (codes of motion, plane, units, distance; end point) are
// still taken over, so that one mistake is not reported again by the blocks behind it.
class Interpreter : private InterpreterMemory {
 public:
  Interpreter(const Point& start_mm, diagnostics::DiagnosticList& diagnostics,
              MachineData machine = {}, Dialect dialect = Dialect::rs274,
              const ExtraWords& start_extra_deg_mm = {});

  // `complete` is false where the grammar stopped inside the line.
  void run(const Block& block, std::uint32_t line, bool complete);
  // X, Y, Z and those extra axes that the machine has.
  [[nodiscard]] Letters axis_letters() const { return kAxisLetters | machine_.extra_axes; }
  // The line that is about to be read: what it works out may ask for its number.
  void enter_line(std::uint32_t line) { line_ = line; }
  // The blocks that follow are of this file: the index in their moves' SourcePosition.
  void enter_file(std::uint16_t file) {
    file_ = file;
    reported_line_ = 0;
  }
  // Says that no block will follow: a curve that is still open is an error.
  void end(std::uint32_t last_line, std::string_view where);

  // A subprogram begins and ends, for M70 to M73.
  void enter_subprogram();
  void leave_subprogram();

  [[nodiscard]] const ModalState& state() const { return state_; }
  [[nodiscard]] std::uint64_t blocks_run() const { return blocks_run_; }
  // Parameters that show the interpreter's state; good as long as it is.
  [[nodiscard]] PredefinedValues& values() { return values_; }
  [[nodiscard]] MoveQueue& moves() { return moves_; }
  [[nodiscard]] bool program_ended() const { return program_ended_; }
  // What the block has raised; it is raised no longer.
  MacroSignal take_signal();
  // Ends the program as M2 does.
  void end_program(diagnostics::SourcePosition source);

 private:
  // interpreter.cpp
  bool execute();
  bool do_words();
  void recover();
  void recover_code(double g);
  void recover_motion(Tenths code);
  bool fail(std::uint32_t offset, const diagnostics::ErrorPage& page, std::string message);
  void report(const diagnostics::Fault& fault);
  void warn(std::uint32_t offset, const diagnostics::ErrorPage& page, std::string message);
  Move& push_move();

  // interpreter_words.cpp
  bool check_words();
  [[nodiscard]] Letters usable_letters(Letters of_motion) const;
  bool check_line_number();
  bool check_axis_users();
  bool explain_idle_axes();
  bool explain_unused(const Word& word);
  bool check_parameters(Letters of_motion);
  bool check_users(Letters of_motion);
  bool check_ranges(Letters ranged);
  void warn_idle_offset_numbers(Letters unused);

  // interpreter_modes.cpp
  void set_units_and_feed_mode();
  bool set_modes();
  void set_units(Units units);
  void set_feed_mode(FeedMode mode);
  bool set_path_mode();
  bool set_tolerances();
  bool set_feed();
  bool dwell();
  bool cutting_feedrate(double length_mm, double& feedrate_mm_s);
  bool inverse_time_feedrate(double length_mm, double& feedrate_mm_s);

  // offsets/interpreter_offsets.cpp
  bool check_axis_taker(Group taker);
  bool select_work_offset();
  [[nodiscard]] Point axis_words_mm() const;
  bool needs_axis_words();
  bool do_once();
  void push_rapid(const Point& end_mm, const ExtraWords& extra_deg_mm);
  bool go_home(const HomePosition& home);
  bool set_length_offset();
  bool set_length_from_table();
  bool add_length_offset();
  const Tool* tool_of_h();
  const Tool* table_tool(double number, std::uint32_t offset);

  // offsets/interpreter_local.cpp, interpreter_extra.cpp
  bool set_local_offset();
  void change_local_offset();
  bool resolve_extra(ExtraWords& end_deg_mm);
  bool refuse_extra(std::string_view where);
  void carry_extra(Move& move, const ExtraWords& end_deg_mm);
  void set_extra_origin(WorkOffset& offset, bool from_position) const;
  bool straight_move_with_extra(const Point& end_mm);
  bool extra_feedrate(const ExtraWay& alone, double& feedrate_mm_s);

  // offsets/interpreter_shape.cpp
  bool select_extended_offset();
  bool shape_program();
  bool scale_program();
  bool scale_factor(char letter, double& factor);
  bool turn_program();
  bool mirror_program();
  bool check_unshaped();

  // offsets/interpreter_data.cpp
  bool set_data();
  bool check_data_words(std::string_view name, Letters usable);
  std::optional<int> data_number(std::string_view name, int least, int most);
  bool set_work_data(bool from_position);
  bool set_extended_data();
  bool set_tool_data(int kind);

  // offsets/interpreter_spindle.cpp
  bool set_speed();
  bool set_spindle_mode();
  [[nodiscard]] double spindle_per_min() const;
  [[nodiscard]] SurfaceFollowing surface_following() const;
  EventMove turn_spindle(Spindle direction);
  void follow_moved_axis();
  bool start_spindle();
  bool orient_spindle();
  bool feedrate_per_revolution(double& feedrate_mm_s);

  // offsets/interpreter_switches.cpp, interpreter_in_out.cpp, interpreter_saved_modes.cpp
  void push_event(EventKind kind, double value, int index = 0);
  bool select_tool();
  bool switch_machine();
  bool change_tool();
  void switch_coolant();
  bool switch_overrides();
  void stop();
  std::optional<int> channel(char letter, int count);
  bool switch_in_out();
  bool wait_for_input();
  bool keep_modes();
  void bring_back(const SavedModes& saved);
  void bring_back_tool_offset(const ModalState& from);

  // compensation/interpreter_compensation.cpp
  bool allowed_while_compensating();
  bool check_motion_while_compensating();
  bool set_compensation();
  bool start_compensation();
  bool compensation_radius(CompensationStart& start);
  bool radius_of_d(CompensationStart& start);
  bool tip_of_l(CompensationStart& start);
  void compensate_moves();
  void keep_contour_in_place(const ModalState& before);

  // cycles/interpreter_cycles.cpp
  bool drill_cycle();
  bool take_cycle_words();
  bool read_cycle(DrillCycle& cycle);
  bool set_cycle_levels(DrillCycle& cycle);
  bool set_cycle_repeats(DrillCycle& cycle);
  bool set_back_bore(DrillCycle& cycle);
  bool check_cycle_modes();
  bool check_cycle_spindle();
  bool run_cycle(const DrillCycle& cycle, const Point& from_mm);
  void push_cycle_step(const CycleStep& step, double feedrate_mm_s);
  [[nodiscard]] std::string motion_name() const;

  // fanuc/interpreter_fanuc.cpp
  [[nodiscard]] Letters letters_of_fanuc() const;
  void settle_cycle_group();
  bool fanuc_dwell();
  std::optional<HomePosition> reference_point();
  bool set_offset_memory(int kind);
  void warn_of_order();

  // cycles/interpreter_probe.cpp
  bool probe();
  bool find_contact(Point& end_mm);
  void push_probe_move(const Point& end_mm, double feedrate_mm_s);

  // interpreter_motion.cpp
  void set_motion(Tenths code);
  bool move();
  [[nodiscard]] bool asks_for_motion(Letters beside_axes) const;
  bool straight_move();
  bool arc_move();
  bool check_machine_coordinates();
  bool rapid_to_words();
  [[nodiscard]] CurveBlock curve_block() const { return {*block_, codes_, state_, line_}; }
  [[nodiscard]] std::uint32_t motion_offset() const;

  // interpreter_curves.cpp
  [[nodiscard]] bool curve_open() const { return nurbs_.active() || uniform_.active(); }
  [[nodiscard]] bool begins_curve() const;
  bool begin_curve();
  bool continue_curve();
  bool reports_open_curve();
  [[nodiscard]] diagnostics::Fault of_curve(diagnostics::Fault fault) const;
  void abandon_curve();
  void skip_curve_of_wrong_block();
  bool leave_skipped_curve();
  bool deliver_curve(NurbsMove curve, std::string_view name);
  bool curve_feed();

  // interpreter_splines.cpp
  bool cubic_spline();
  bool quadratic_spline();
  [[nodiscard]] bool is_high_speed_mode() const;
  [[nodiscard]] std::array<double, 2> handle_mm(double x_word, double y_word) const;
  bool check_spline_axes(std::string_view name);
  bool deliver_spline(NurbsMove curve, std::string_view name);
};

}  // namespace kerf::parser
