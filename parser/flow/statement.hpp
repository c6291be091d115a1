// A line that says which line is next.
#pragma once

#include <cstdint>

namespace kerf::parser {

enum class Keyword : std::uint8_t {
  none,
  // o-words
  o_sub,
  o_endsub,
  o_return,
  o_call,
  o_if,
  o_elseif,
  o_else,
  o_endif,
  o_while,
  o_endwhile,
  o_do,
  o_do_while,  // the while that closes a do
  o_repeat,
  o_endrepeat,
  o_break,
  o_continue,
  // both dialects
  program,  // O1234 and no more: where a subprogram of M98 begins
  // custom macro B
  macro_if,     // IF [..] GOTO n, IF [..] THEN ..
  macro_goto,   // GOTO n
  macro_while,  // WHILE [..] DOm
  macro_do,     // DOm
  macro_end,    // ENDm
  // One that is wrong and has been reported.
  wrong,
};

// What is after a statement's label or keyword is found by its offset in the line; the other
// fields are indices of statements in the same text, 0 where there is none (yet).
struct Statement {
  Keyword keyword = Keyword::none;
  bool computed_label = false;  // o[#1] call
  std::uint32_t repeats = 0;    // how many repeat loops are around it
  std::uint32_t line = 0;       // index in the text
  std::uint32_t label_at = 0;   // offset of the label after the o
  std::uint32_t keyword_at = 0;
  std::uint32_t rest = 0;    // offset after the keyword
  std::uint32_t label = 0;   // the label's index; for Fanuc the number of DO and END
  std::uint32_t around = 0;  // what opens the innermost structure around it
  std::uint32_t head = 0;    // what opens the structure it belongs to
  std::uint32_t next = 0;    // the next clause: elseif, else or the close
  std::uint32_t close = 0;   // of what opens: its close
};

}  // namespace kerf::parser
