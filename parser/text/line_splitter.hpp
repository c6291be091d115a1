// Bytes in pieces to numbered lines.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace kerf::parser {

struct NumberedLine {
  std::string_view text;  // without its end; valid until the next call of the splitter
  std::uint32_t number = 0;
  bool too_long = false;  // text is then its beginning, the rest is dropped
  bool left_out = false;  // by a switch of block delete, as they stood when it was read
};

// CR, LF, CRLF and LFCR each end a line, wherever the pieces are cut. What is held is the rest of
// the pieces fed and not read, and at most kMaxLine bytes of an unfinished line.
class LineSplitter {
 public:
  static constexpr std::size_t kMaxLine = std::size_t{64} * 1024;

  void feed(std::string_view bytes);
  void finish() { finished_ = true; }
  // False: feed more, or the end.
  bool next(NumberedLine& line);
  [[nodiscard]] bool finished() const { return finished_; }
  [[nodiscard]] std::uint32_t lines() const { return lines_; }
  [[nodiscard]] std::size_t held_bytes() const { return buffer_.capacity(); }

 private:
  void skip_rest_of_line_end();
  bool drop_rest_of_long_line();
  std::size_t find_line_end();
  void take(std::size_t length, NumberedLine& line);

  std::string buffer_;
  std::size_t at_ = 0;       // start of the next line
  std::size_t scanned_ = 0;  // no line end before this
  // The first place from at_ on with each, or the buffer's end.
  struct LineEnd {
    char byte;
    std::size_t next = 0;
  };
  std::array<LineEnd, 2> ends_{LineEnd{'\r'}, LineEnd{'\n'}};
  std::uint32_t lines_ = 0;
  char ended_by_ = '\0';  // the byte that ended the line before
  bool dropping_ = false;
  bool finished_ = false;
};

}  // namespace kerf::parser
