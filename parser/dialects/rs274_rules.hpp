#pragma once

#include "parser/dialects/dialect_rules.hpp"

namespace kerf::parser {

inline constexpr DialectRules kRs274Rules{.control_codes = false,
                                          .cycle_group = false,
                                          .starts_at_initial = false,
                                          .machine_rapid = false,
                                          .dwell_in_axes = false,
                                          .usual_order = 10.0,
                                          .zero_is_no_offset = false,
                                          .keeps_d = false,
                                          .side_change_known = false,
                                          .offset_memory = false,
                                          .speed_limit_in_g92 = false,
                                          .cycle_dwell_unit_s = 1.0,
                                          .cycle_dwell_optional = false,
                                          .levels_keep_mode = false,
                                          .repeats_in_k = false,
                                          .r_alone_drills = false,
                                          .back_bore_aside = true,
                                          .numbered_delete = false,
                                          .blocks_behind_semicolon = false,
                                          .active_comments = true,
                                          .least_increments = false,
                                          .o_words = true,
                                          .macro_statements = false,
                                          .numbered_programs = false,
                                          .macro_calls = false,
                                          .repeats_in_p = false,
                                          .first_call_code = 98.0,
                                          .macro_arithmetic = false,
                                          .named_variables = true,
                                          .assigns_at_once = false,
                                          .vacant_variables = false,
                                          .control_variables = false,
                                          .locals = 30,
                                          .plain_end = 5001,
                                          .first_asked = 5001,
                                          .variables_end = 5602};

}  // namespace kerf::parser
