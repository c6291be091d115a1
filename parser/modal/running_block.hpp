// A block on its way through the units of the interpreter.
#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include "diagnostics/diagnostic_list.hpp"
#include "diagnostics/fault.hpp"
#include "parser/block/block.hpp"
#include "parser/dialects/dialect_rules.hpp"
#include "parser/modal/codes.hpp"
#include "parser/modal/modal_state.hpp"
#include "parser/modal/tool_table.hpp"
#include "parser/moves/move_queue.hpp"

namespace kerf::parser {

using diagnostics::Done;
using diagnostics::Expected;
using diagnostics::fail;
using diagnostics::fault_of;

// Where the moves of a block go, and what all of them carry.
struct MoveSink {
  MoveQueue& moves;
  diagnostics::SourcePosition source;  // of the block's first word
  std::uint64_t block_number = 0;      // of the program's run: Move::block
  Letters auxiliary_axes = 0;          // those of A, B, C, U, V, W that the machine has

  // A move that stays where `state` is, in the modes in force.
  // NOLINTNEXTLINE(modernize-use-nodiscard): a rapid or a feed needs no more than its modes.
  Move& push_move(const ModalState& state) const;
  void push_event(const ModalState& state, EventMove event) const {
    push_move(state).shape = event;
  }
};

// What every unit is given: the block's words and codes, and where its moves and warnings go. The
// modal state comes beside it, to be read or to be changed.
struct RunningBlock : MoveSink {
  const BlockWords& block;
  const BlockCodes& codes;
  diagnostics::DiagnosticList& diagnostics;
  const DialectRules& rules;

  [[nodiscard]] Letters axis_letters() const { return kAxisLetters | auxiliary_axes; }
  [[nodiscard]] const Word& code_word(Group group) const {
    return parser::code_word(block, codes, group);
  }
  // The code of the group as the program has it, in capitals.
  [[nodiscard]] std::string name_of(Group group) const;
  // Where a message about the motion points: at its code, else at the first word that moves.
  [[nodiscard]] std::uint32_t motion_offset() const;

  void warn(std::uint32_t offset, const diagnostics::ErrorPage& page, std::string message) const {
    diagnostics.add({source.line, offset + 1}, page, std::move(message));
  }
};

// The move takes the auxiliary axes there.
void carry_auxiliary(const MoveSink& at, ModalState& state, Move& move,
                     const AuxiliaryWords& end_deg_mm);

// A code of group 1, or G80, comes into force.
void set_motion(const RunningBlock& at, ModalState& state, Tenths code);
// "G81"
std::string motion_name(Motion motion);
// Of the motion in force.
std::string motion_name(const ModalState& state);

// The tool of that number, which the word at `offset` gives. Never null; good until the table
// changes.
Expected<const Tool*> named_tool(const RunningBlock& at, const ToolTable& tools, double number,
                                 std::uint32_t offset);

}  // namespace kerf::parser
