// The parser's door: bytes in, in pieces of any size; moves and diagnostics out.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/diagnostic.hpp"
#include "parser/flow/numbered_message.hpp"
#include "parser/flow/reader_options.hpp"
#include "parser/moves/move.hpp"

namespace kerf::parser {

class ProgramRun;

// Reads one program. Memory does not grow with its length: the piece fed last, a line of at most
// 64 KiB, the modal state and one NURBS curve of at most 20,000 control points are all that is
// held; so fetch the moves of a piece before feeding the next one. A program with o-words or calls
// has its text held from the first of them on; in the Fanuc dialect from its beginning, as long as
// that is at most 4 MiB without a macro statement.
//
// A move that is too short to be one (short_moves.hpp) is checked but not delivered.
// A program that ends with its last byte, without M2, M30 or a closing %, gets a warning and no
// program_end event. After an error reading goes on at the next block; moves that come
// after an error only serve to find further errors and must not be run.
class ProgramReader {
 public:
  explicit ProgramReader(ReaderOptions options = {});
  ~ProgramReader();
  ProgramReader(ProgramReader&&) noexcept;
  ProgramReader& operator=(ProgramReader&&) noexcept;

  // Takes the next bytes of the program. Precondition: finish() was not called.
  void feed(std::string_view bytes);
  // Says that no bytes will follow.
  void finish();

  // Of blocks that are not read yet.
  void set_block_delete(const BlockDelete& switches);
  void set_tool(const Tool& tool);

  // The next move, if the bytes so far make one up. False: feed() more, or the end if finished.
  bool next(Move& move);

  // What the machine is asked where the last move ended (ReaderOptions::answers): next() is false
  // until answer(). Nothing: nothing is asked.
  [[nodiscard]] const std::optional<MachineQuestion>& question() const;
  // Precondition: there is a question.
  void answer(const MachineAnswer& answer);

  // What the program told the operator in the text that the last next() read; each belongs before
  // the block of its number. Where there are more than kMaxMessages, the first of them.
  [[nodiscard]] const std::vector<NumberedMessage>& messages() const;

  // What is in force after the block that was read last. The reference is good until next().
  [[nodiscard]] const ModalState& modal_state() const;
  // What is left to the next program, with `modal` in force; nothing: what was read last is. After
  // M2, M30 or a closing % the codes are what LinuxCNC makes of them there.
  [[nodiscard]] ReaderState state_left(const std::optional<ModalState>& modal) const;
  // The number of that block, as Move::block counts.
  [[nodiscard]] std::uint64_t blocks_read() const;

  // True once the program's end was met: M2, M30, the closing % or the last byte.
  [[nodiscard]] bool at_end() const;
  // Those of what runs: what is said of text after the program's end is in diagnostics() alone.
  [[nodiscard]] bool has_errors() const;
  // Bytes of program text held because it may be read again; 0 for a program without flow.
  [[nodiscard]] std::size_t held_bytes() const;
  // Of the file that SourcePosition::file names; empty for 0, the program itself.
  [[nodiscard]] std::string_view file_name(std::uint16_t file) const;
  // Errors and warnings in the order of the text, at most max_errors errors.
  [[nodiscard]] const std::vector<diagnostics::Diagnostic>& diagnostics() const;

 private:
  std::unique_ptr<ProgramRun> run_;
};

}  // namespace kerf::parser
