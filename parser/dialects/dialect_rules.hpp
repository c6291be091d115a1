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

  // Text, variables and expressions.
  bool macro_b;        // custom macro B and program numbers; else o-words and names
  std::size_t locals;  // #1 and on, which each call has anew
  std::size_t
      plain_end;  // behind the variables that are the program's own and there from the start
  std::size_t first_asked;  // from here on the machine's state is asked first
  std::size_t variables_end;
};

}  // namespace kerf::parser
