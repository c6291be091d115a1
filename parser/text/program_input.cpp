#include "parser/text/program_input.hpp"

#include <utility>

#include "diagnostics/errors/pages.hpp"
#include "diagnostics/fault.hpp"
#include "parser/text/character_error.hpp"
#include "parser/text/number.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

using diagnostics::fail;

// Files that are no part programs at all: UTF-16, binary data, a web page, another control's
// language.
diagnostics::Done check_first_line(std::string_view line) {
  const auto byte = [&](std::size_t i) {
    return i < line.size() ? static_cast<unsigned char>(line[i]) : 0x100U;
  };
  if ((byte(0) == 0xFF && byte(1) == 0xFE) || (byte(0) == 0xFE && byte(1) == 0xFF)) {
    return fail(0, errors::kUtf16, "the file is UTF-16, ASCII or UTF-8 is expected");
  }
  if (detail::is_letter(static_cast<char>(byte(0) & 0x7FU)) && byte(1) == 0) {
    return fail(0, errors::kUtf16,
                "the file is UTF-16 without a byte order mark, ASCII or UTF-8 is expected");
  }
  if (byte(0) < 0x20 && byte(0) != '\t') {
    return fail(0, errors::kNotText,
                joined({"the file is not text (byte 0x", hex(byte(0), 2), " at its start)"}));
  }
  const std::size_t first = line.find_first_not_of(" \t");
  if (first != std::string_view::npos && line[first] == '<') {
    return fail(first, errors::kMarkup,
                "this is HTML or XML ('<' at its start), G-code is expected");
  }
  if (line.substr(0, 200).find("BEGIN PGM") != std::string_view::npos) {
    return fail(0, errors::kHeidenhain,
                "this is a HEIDENHAIN program ('BEGIN PGM'), G-code is expected");
  }
  return {};
}

}  // namespace

// Text may end with end marks. Whether it really ends there only what follows can show.
void ProgramInput::take_end_mark(NumberedLine& line) {
  const std::size_t last = line.text.find_last_not_of("\x1A \t");
  const std::size_t behind = last == std::string_view::npos ? 0 : last + 1;
  if (end_mark_ && behind > 0 && !passes_over_) {
    passes_over_ = true;
    diagnostics_->add_at(*end_mark_, errors::kControlByte,
                         "byte 0x1A is not allowed: the text goes on after it");
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

bool ProgramInput::accept_first(NumberedLine& line) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (line.text.substr(0, kByteOrderMark.size()) == kByteOrderMark) {
    line.text.remove_prefix(kByteOrderMark.size());
    diagnostics_->add({1, 1}, errors::kByteOrderMark, "byte order mark ignored");
  }
  diagnostics_->at_line(line.number, line.text);
  if (const diagnostics::Done program = check_first_line(line.text); !program) {
    const diagnostics::Fault& fault = *program.error();
    diagnostics_->add({1, fault.offset + 1}, *fault.page, fault.message);
    refused_ = true;
  }
  return !refused_;
}

}  // namespace kerf::parser
