// What a ProgramReader does, in two parts: which line is next, and what is done with it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "diagnostics/diagnostic_list.hpp"
#include "parser/block/block.hpp"
#include "parser/expressions/evaluator.hpp"
#include "parser/expressions/parameters.hpp"
#include "parser/flow/call.hpp"
#include "parser/flow/flow.hpp"
#include "parser/flow/modal_calls.hpp"
#include "parser/flow/numbered_message.hpp"
#include "parser/flow/reader_options.hpp"
#include "parser/interpreter/interpreter.hpp"
#include "parser/moves/short_moves.hpp"
#include "parser/offsets/machine_values.hpp"
#include "parser/reader/block_warnings.hpp"
#include "parser/text/program_input.hpp"

namespace kerf::parser {

class ProgramRun {
 public:
  explicit ProgramRun(ReaderOptions options)
      : options_(std::move(options)),
        rules_(rules_of(options_.dialect)),
        diagnostics_(options_.max_errors),
        input_(diagnostics_),
        interpreter_(memory_of(options_), diagnostics_),
        values_(interpreter_.memory()),
        parameters_(options_.begins_with ? options_.begins_with->parameters
                                         : Parameters(options_.dialect)),
        evaluator_(parameters_),
        flow_(options_, input_, evaluator_, diagnostics_, interpreter_) {
    parameters_.use(values_);
  }

  ProgramInput& input() { return input_; }
  void set_block_delete(const BlockDelete& switches) { options_.block_delete = switches; }
  void set_tool(const Tool& tool) { interpreter_.memory().machine.tools.put(tool); }
  bool next(Move& move);  // program_lines.cpp
  [[nodiscard]] const std::optional<MachineQuestion>& question() const { return question_; }
  void answer(const MachineAnswer& answer);
  [[nodiscard]] bool at_end() const { return ended_ && all_fetched_ && !flow_.needs_rest(); }
  [[nodiscard]] const diagnostics::DiagnosticList& diagnostics() const { return diagnostics_; }
  [[nodiscard]] bool has_errors() const { return flow_.failed(); }
  [[nodiscard]] const std::vector<NumberedMessage>& messages() const { return messages_; }
  [[nodiscard]] const ModalState& modal_state() const { return interpreter_.state(); }
  [[nodiscard]] ReaderState state_left(
      const std::optional<ModalState>& modal) const;  // state_left.cpp
  [[nodiscard]] std::uint64_t blocks_run() const { return interpreter_.blocks_run(); }
  [[nodiscard]] std::size_t held_bytes() const { return flow_.held_bytes(); }
  [[nodiscard]] std::string_view file_name(std::uint16_t file) const {
    return flow_.file_name(file);
  }

 private:
  [[nodiscard]] static ProgramMemory memory_of(const ReaderOptions& options);  // state_left.cpp

  // program_lines.cpp
  bool next_move(Move& move);  // however short
  void report_idle_program();
  bool next_line(NumberedLine& line);
  bool next_plain_line(NumberedLine& line);
  bool begins_flow(const NumberedLine& line) const;
  bool read_percent(const NumberedLine& line, std::size_t at);
  void read_rest(const NumberedLine& line);
  void reach_end();

  // program_blocks.cpp
  void read_line(const NumberedLine& line);
  void read_code(const NumberedLine& line);
  void run_block(const NumberedLine& line, bool complete);
  bool act_on_comment(const NumberedLine& line);
  bool is_program_number(const BlockWords& block, std::uint32_t line);
  bool run_call(const NumberedLine& line, bool complete);
  void run_program_call(const NumberedLine& line, const Word& code);
  void run_without_call(const NumberedLine& line, const Word& code);
  void report(const NumberedLine& line, const diagnostics::Fault& fault);
  void run_macro_call(const NumberedLine& line, const Word& code);
  void call(const NumberedLine& line, Call call);
  void return_from_call(const NumberedLine& line, const Return& back);

  // fanuc/program_blocks_fanuc.cpp
  [[nodiscard]] bool has_program_name() const;
  void run_named_call(const NumberedLine& line);
  void read_behind_semicolon(const NumberedLine& line);
  void act_on_signal(const NumberedLine& line);
  void check_points(const NumberedLine& line);
  void interpret(const NumberedLine& line, bool complete);
  void run_fanuc_block(const NumberedLine& line, bool complete);

  ReaderOptions options_;
  const DialectRules& rules_;
  diagnostics::DiagnosticList diagnostics_;
  ProgramInput input_;
  Interpreter interpreter_;
  MachineValues values_;
  Parameters parameters_;
  Evaluator evaluator_;
  Flow flow_;
  ShortMoves short_moves_;
  BlockWords block_;
  SaidOnce said_;
  bool called_ = false;                      // the block is a call or a return
  std::string behind_semicolon_;             // the rest of a Fanuc line with more than one block
  std::string program_name_;                 // <NAME> of the block's call, plain; empty: none
  std::string without_name_;                 // the line with blanks in its place
  ModalCalls modal_calls_;                   // G66
  std::optional<MachineQuestion> question_;  // that the machine has not answered
  bool ended_ = false;                       // the program, not the bytes
  bool all_fetched_ = true;                  // all its moves are fetched
  bool any_block_ = false;
  bool opened_by_percent_ = false;
  bool closed_by_percent_ = false;
  bool rest_reported_ = false;
  bool does_anything_ = false;  // but end
  std::uint32_t opening_line_ = 0;
  std::vector<NumberedMessage> messages_;  // of the text that the last next() read
};

}  // namespace kerf::parser
