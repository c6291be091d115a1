#pragma once

#include "parser/dialects/dialect_rules.hpp"

namespace kerf::parser {

inline constexpr DialectRules kFanucRules{.control_codes = true,
                                          .cycle_group = true,
                                          .starts_at_initial = true,
                                          .machine_rapid = true,
                                          .dwell_in_axes = true,
                                          .usual_order = 4.0,
                                          .zero_is_no_offset = true,
                                          .keeps_d = true,
                                          .side_change_known = true,
                                          .offset_memory = true,
                                          .speed_limit_in_g92 = true,
                                          .cycle_dwell_unit_s = 0.001,
                                          .cycle_dwell_optional = true,
                                          .levels_keep_mode = true,
                                          .repeats_in_k = true,
                                          .r_alone_drills = true,
                                          .back_bore_aside = false,
                                          .numbered_delete = true,
                                          .blocks_behind_semicolon = true,
                                          .active_comments = false,
                                          .least_increments = true,
                                          .o_words = false,
                                          .macro_statements = true,
                                          .numbered_programs = true,
                                          .macro_calls = true,
                                          .repeats_in_p = true,
                                          .first_call_code = 97.0,
                                          .macro_arithmetic = true,
                                          .named_variables = false,
                                          .assigns_at_once = true,
                                          .vacant_variables = true,
                                          .control_variables = true,
                                          .locals = 33,
                                          .plain_end = 34,
                                          .first_asked = 1000,
                                          .variables_end = 1000};

}  // namespace kerf::parser
