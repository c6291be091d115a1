// What one dialect says otherwise than another, as data.
#pragma once

#include <cstddef>

namespace kerf::parser {

struct DialectRules {
  // Codes and groups.
  bool control_codes;      // G44, G50, G51, G50.1, G51.1, G54.1, G68, G69, G30 P, G5.1 R
  bool cycle_group;        // cycles and G80 lie over the motion, in a group of their own
  bool starts_at_initial;  // G98 is in force at the start, not G99
  bool machine_rapid;      // G53 without a motion code is a rapid
  bool dwell_in_axes;      // G4 X and U in seconds, P in milliseconds; else P in seconds
  double usual_order;      // G6.2 P above it is warned of

  // Offsets and the spindle.
  bool zero_is_no_offset;   // H0 and D0; else they name the tool in the spindle
  bool keeps_d;             // D holds from block to block
  bool side_change_known;   // G41 under G42 means something: it is refused by that name
  bool offset_memory;       // G10 L10 to L13 by offset number, L20 for G54.1; G91 adds
  bool speed_limit_in_g92;  // the highest speed of G96 is S of G92, and G96 leaves it as it is

  // Canned cycles.
  double cycle_dwell_unit_s;  // what P counts in
  bool cycle_dwell_optional;  // where a cycle dwells, and beside pecks too
  bool levels_keep_mode;      // R and Z are read in the G90 or G91 of the block that gives them
  bool repeats_in_k;          // K beside L; 0 is usual
  bool r_alone_drills;
  bool back_bore_aside;  // G87 goes aside by I, J, K; else by Q, which is not supported

  // Text.
  bool numbered_delete;          // '/2' to '/9' are block deletes of their own
  bool blocks_behind_semicolon;  // ';' ends a block; else it begins a comment
  bool active_comments;          // (MSG, text) is a message, (ABORT, text) ends the program
  bool least_increments;         // the machine says what a number without a point counts in

  // Flow.
  bool o_words;            // o100 if, o<name> call and so on
  bool macro_statements;   // IF, WHILE and GOTO of custom macro B
  bool numbered_programs;  // ':' is O too, and a program ends where the next one begins
  bool macro_calls;        // G65 to G67, and programs that are called by <NAME>
  bool repeats_in_p;       // P30100 of M98 is L3 P100
  double first_call_code;  // M97 or M98

  // Variables and expressions.
  bool macro_arithmetic;    // the functions and operators of custom macro B; else of RS274/NGC
  bool named_variables;     // #<name>
  bool assigns_at_once;     // else after the words of the block
  bool vacant_variables;    // #0, and what was never set; else that is 0
  bool control_variables;   // from #1000 on they are those of a Fanuc control; else of LinuxCNC
  std::size_t locals;       // #1 and on, which each call has anew
  std::size_t plain_end;    // after the variables that only the program writes
  std::size_t first_asked;  // from here on the machine's state is asked first
  std::size_t variables_end;
};

}  // namespace kerf::parser
