// One text, the program's own or a subprogram's file, with what says which of its lines is next.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <kerf/program_data.hpp>

#include "parser/dialects/dialect.hpp"
#include "parser/flow/labels.hpp"
#include "parser/flow/sequence_numbers.hpp"
#include "parser/flow/statement.hpp"
#include "parser/flow/structure.hpp"
#include "parser/flow/text_store.hpp"
#include "parser/text/line_splitter.hpp"

namespace kerf::parser {

struct TextOrigin {
  Dialect dialect = Dialect::rs274;
  std::uint32_t first_line = 1;  // the number of the first line taken in
  std::uint16_t file = 0;        // as in SourcePosition
  std::string file_name{};       // empty: the program itself
};

// Lines are taken in one by one, once, and read as often as the flow goes over them. Memory: the
// text and what TextStore, Labels and SequenceNumbers add, linear in the text's length.
class ProgramText {
 public:
  explicit ProgramText(TextOrigin origin);
  ProgramText(const ProgramText&) = delete;
  ProgramText& operator=(const ProgramText&) = delete;

  // Precondition: not closed(). A closing '%' closes the text. A line that is left out is no
  // statement.
  void take(const NumberedLine& line);
  // No line follows.
  void close();
  [[nodiscard]] bool closed() const { return closed_; }

  [[nodiscard]] std::uint32_t size() const { return store_.size(); }
  [[nodiscard]] const StoredLine& line(std::uint32_t index) const { return store_[index]; }
  [[nodiscard]] std::uint32_t number_of(std::uint32_t index) const {
    return origin_.first_line + index;
  }
  [[nodiscard]] const Statement& statement(std::uint32_t index) const { return statements_[index]; }
  [[nodiscard]] bool has_statements() const { return statements_.size() > 1; }
  // The number of the line in which the first `sub` stands; 0: there is none.
  [[nodiscard]] std::uint32_t first_sub_line() const;
  [[nodiscard]] const TextOrigin& origin() const { return origin_; }
  [[nodiscard]] Labels& labels() { return labels_; }
  [[nodiscard]] SequenceNumbers& sequence_numbers() { return numbers_; }
  [[nodiscard]] bool structure_open() const { return structure_.open(); }
  // Lines of the program that `line` stands in: from its number's line to the next one's, or to
  // the end of what is there so far.
  struct Range {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
  };
  [[nodiscard]] Range program_around(std::uint32_t line) const;
  // What opens the macro loop that the line after `line` stands in; 0: none.
  [[nodiscard]] std::uint32_t structure_around(std::uint32_t line) const;
  // Whether a statement is the program number that the text begins with.
  [[nodiscard]] bool is_head(std::uint32_t statement) const { return statement == head_; }
  [[nodiscard]] std::size_t text_bytes() const { return store_.text_bytes(); }
  [[nodiscard]] std::size_t held_bytes() const;

  // Faults found since the last call.
  std::vector<StatementFault> take_faults();
  [[nodiscard]] bool has_faults() const { return !faults_.empty(); }

 private:
  void take_statement(std::uint32_t line, std::string_view text, std::size_t at);
  void name_statement(std::uint32_t index, std::string_view text);
  bool take_percent(std::string_view text, std::size_t at);

  TextOrigin origin_;
  TextStore store_;
  std::vector<Statement> statements_{Statement{}};  // 0 is no statement
  Labels labels_;
  SequenceNumbers numbers_;
  Structure structure_;
  std::vector<std::uint32_t> programs_;  // lines of program numbers
  std::vector<StatementFault> faults_;
  bool closed_ = false;
  bool anything_ = false;   // but blank lines and comments
  bool any_block_ = false;  // the same, '%' left out too
  std::size_t head_ = 0;
};

}  // namespace kerf::parser
