#include "parser/text/file_error.hpp"

#include "diagnostics/errors/pages.hpp"
#include "parser/text/character_error.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

constexpr bool is_letter(char c) {
  return static_cast<unsigned char>((c | 0x20) - 'a') < 26;
}

}  // namespace

diagnostics::Fault explain_first_line(std::string_view line) {
  const auto byte = [&](std::size_t i) {
    return i < line.size() ? static_cast<unsigned char>(line[i]) : 0x100U;
  };
  if ((byte(0) == 0xFF && byte(1) == 0xFE) || (byte(0) == 0xFE && byte(1) == 0xFF)) {
    return {0, "the file is UTF-16, ASCII or UTF-8 is expected", &errors::kUtf16};
  }
  if (is_letter(static_cast<char>(byte(0) & 0x7FU)) && byte(1) == 0) {
    return {0, "the file is UTF-16 without a byte order mark, ASCII or UTF-8 is expected",
            &errors::kUtf16};
  }
  if (byte(0) < 0x20 && byte(0) != '\t') {
    return {0, joined({"the file is not text (byte 0x", hex(byte(0), 2), " at its start)"}),
            &errors::kNotText};
  }
  const std::size_t first = line.find_first_not_of(" \t");
  if (first != std::string_view::npos && line[first] == '<') {
    return {static_cast<std::uint32_t>(first),
            "this is HTML or XML ('<' at its start), G-code is expected", &errors::kMarkup};
  }
  if (line.substr(0, 200).find("BEGIN PGM") != std::string_view::npos) {
    return {0, "this is a HEIDENHAIN program ('BEGIN PGM'), G-code is expected",
            &errors::kHeidenhain};
  }
  return {};
}

}  // namespace kerf::parser
