// Which statement closes which: paired when the text is taken in, looked up when it runs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "diagnostics/diagnostic.hpp"
#include "parser/flow/labels.hpp"
#include "parser/flow/statement.hpp"

namespace kerf::parser {

// A fault of a line that need not be the last one taken in.
struct StatementFault {
  std::uint32_t line = 0;    // index in the text
  std::uint32_t offset = 0;  // in the line
  const diagnostics::ErrorPage* page = nullptr;
  std::string message;
};

// A stack of what is open. A close first looks for its opener by label, down to the sub around it;
// what stands above was never closed. A close whose label fits nothing closes the innermost
// structure of its kind, with an error at the opener: most often a label was mistyped, and one
// message for it is enough.
class Structure {
 public:
  // What is nested deeper is a fault, and of what follows it no structure is made any more.
  static constexpr std::size_t kMaxDepth = 64;

  // Lines of the text are shown as counted from `first_line`. Both others must outlive this.
  Structure(std::vector<Statement>& statements, Labels& labels, std::uint32_t first_line)
      : statements_(&statements), labels_(&labels), first_line_(first_line) {}

  // The statement at `index` comes next. Sets its place in the structure; one that fits nowhere
  // becomes Keyword::wrong.
  void take(std::uint32_t index, std::vector<StatementFault>& faults);
  // Nothing comes any more: what is open is a fault.
  void finish(std::vector<StatementFault>& faults);
  [[nodiscard]] bool open() const { return !open_.empty(); }
  // What opened the innermost structure; 0: none is open.
  [[nodiscard]] std::uint32_t innermost() const { return open_.empty() ? 0 : open_.back().opener; }

 private:
  struct Open {
    std::uint32_t opener = 0;
    std::uint32_t clause = 0;  // the last one: the opener, elseif or else
    Keyword kind = Keyword::none;
  };

  void open(std::uint32_t index, std::vector<StatementFault>& faults);
  void close(std::uint32_t index, Keyword kind, std::vector<StatementFault>& faults);
  void branch(std::uint32_t index, std::vector<StatementFault>& faults);
  void leave_loop(std::uint32_t index, std::vector<StatementFault>& faults);
  void loop_end(std::uint32_t index, std::vector<StatementFault>& faults);
  void drop_above(std::size_t depth, std::vector<StatementFault>& faults);
  void report_open(const Open& open, std::vector<StatementFault>& faults) const;
  [[nodiscard]] std::size_t find(Keyword kind, std::uint32_t label) const;
  [[nodiscard]] std::size_t sub_around() const;
  [[nodiscard]] std::string shown(std::uint32_t index) const;
  Statement& at(std::uint32_t index) { return (*statements_)[index]; }

  static constexpr std::size_t kNowhere = static_cast<std::size_t>(-1);

  std::vector<Statement>* statements_;
  Labels* labels_;
  std::vector<Open> open_;
  std::uint32_t first_line_;
  std::uint32_t repeats_ = 0;
  bool too_deep_ = false;
};

}  // namespace kerf::parser
