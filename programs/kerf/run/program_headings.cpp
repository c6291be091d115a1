#include "programs/kerf/run/program_headings.hpp"

#include <utility>

#include "parser/text/line_splitter.hpp"
#include "programs/kerf/io/interrupt.hpp"

namespace kerf::program {

std::vector<Heading> headings_in(ProgramFile& file) {
  std::vector<Heading> headings;
  parser::LineSplitter lines;
  while (!lines.finished() && headings.size() < kMaxHeadings && !stop_requested()) {
    const auto piece = file.read();
    if (!piece || piece->empty()) {
      lines.finish();
    } else {
      lines.feed(*piece);
    }
    for (parser::NumberedLine line; headings.size() < kMaxHeadings && lines.next(line);) {
      if (std::string text = heading_of(line.text); !text.empty()) {
        headings.push_back({.line = line.number, .text = std::move(text)});
      }
    }
  }
  return headings;
}

}  // namespace kerf::program
