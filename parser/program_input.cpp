#include "parser/program_input.hpp"

#include <utility>

#include "parser/errors/files.hpp"
#include "parser/file_error.hpp"

namespace kerf::parser {

bool ProgramInput::accept_first(Line& line) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (line.text.substr(0, kByteOrderMark.size()) == kByteOrderMark) {
    line.text.remove_prefix(kByteOrderMark.size());
    diagnostics_->add({1, 1}, errors::kByteOrderMark, "byte order mark ignored");
  }
  diagnostics_->at_line(line.number, line.text);
  Fault fault = explain_first_line(line.text);
  if (fault.message.empty()) {
    return true;
  }
  diagnostics_->add({1, fault.offset + 1}, *fault.page, std::move(fault.message));
  refused_ = true;
  return false;
}

}  // namespace kerf::parser
