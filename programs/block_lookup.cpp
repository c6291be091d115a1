#include "programs/block_lookup.hpp"

#include <algorithm>

#include "parser/line_splitter.hpp"

namespace kerf::program {

using parser::Diagnostic;

void fill_in_blocks(std::vector<Diagnostic>& diagnostics, ProgramFile& file) {
  std::vector<Diagnostic*> open;
  for (Diagnostic& diagnostic : diagnostics) {
    if (diagnostic.block.text.empty() && diagnostic.file.empty() && diagnostic.source.column > 0) {
      open.push_back(&diagnostic);
    }
  }
  std::stable_sort(open.begin(), open.end(), [](const Diagnostic* a, const Diagnostic* b) {
    return a->source.line < b->source.line;
  });
  auto next = open.begin();
  const auto take = [&](const parser::Line& line) {
    for (; next != open.end() && (*next)->source.line <= line.number; ++next) {
      if ((*next)->source.line == line.number) {
        (*next)->block = parser::excerpt_of(line.text, (*next)->source.column - 1);
      }
    }
  };
  file.rewind();
  parser::LineSplitter lines;
  while (next != open.end() && !lines.finished()) {
    const auto piece = file.read();
    if (!piece || piece->empty()) {
      lines.finish();
    } else {
      lines.feed(*piece);
    }
    for (parser::Line line; next != open.end() && lines.next(line);) {
      take(line);
    }
  }
}

}  // namespace kerf::program
