#include "parser/text/program_input.hpp"

#include <utility>

#include "diagnostics/errors/pages.hpp"
#include "parser/text/file_error.hpp"

namespace kerf::parser {

// Text may end with end marks. Whether it really ends there only what follows can show.
void ProgramInput::take_end_mark(Line& line) {
  const std::size_t last = line.text.find_last_not_of("\x1A \t");
  const std::size_t behind = last == std::string_view::npos ? 0 : last + 1;
  if (end_mark_ && behind > 0 && !passes_over_) {
    passes_over_ = true;
    diagnostics_->add_at(*end_mark_, errors::kControlByte,
                         "byte 0x1A is not allowed: the text goes on behind it");
  }
  const std::size_t mark = line.text.find(kEndMark, behind);
  if (mark == std::string_view::npos) {
    return;
  }
  if (!end_mark_) {
    diagnostics_->at_line(line.number, line.text);
    end_mark_ = diagnostics_->place({line.number, static_cast<std::uint32_t>(mark) + 1});
    diagnostics_->add_at(*end_mark_, errors::kEndMark,
                         "byte 0x1A (Ctrl-Z) at the end of the text is ignored");
  }
  line.text = line.text.substr(0, mark);
}

bool ProgramInput::accept_first(Line& line) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (line.text.substr(0, kByteOrderMark.size()) == kByteOrderMark) {
    line.text.remove_prefix(kByteOrderMark.size());
    diagnostics_->add({1, 1}, errors::kByteOrderMark, "byte order mark ignored");
  }
  diagnostics_->at_line(line.number, line.text);
  diagnostics::Fault fault = explain_first_line(line.text);
  if (fault.message.empty()) {
    return true;
  }
  diagnostics_->add({1, fault.offset + 1}, *fault.page, std::move(fault.message));
  refused_ = true;
  return false;
}

}  // namespace kerf::parser
