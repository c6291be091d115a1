#include "programs/kerf/run/block_lookup.hpp"

#include <algorithm>
#include <map>
#include <string>

#include "parser/text/line_splitter.hpp"

namespace kerf::program {

using diagnostics::Diagnostic;

namespace {

// Diagnostics about one file that have no block yet.
using Open = std::vector<Diagnostic*>;

void fill_in(Open open, ProgramFile& file) {
  std::stable_sort(open.begin(), open.end(), [](const Diagnostic* a, const Diagnostic* b) {
    return a->source.line < b->source.line;
  });
  auto next = open.begin();
  const auto take = [&](const parser::NumberedLine& line) {
    for (; next != open.end() && (*next)->source.line <= line.number; ++next) {
      if ((*next)->source.line == line.number) {
        (*next)->block = diagnostics::excerpt_of(line.text, (*next)->source.column - 1);
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
    for (parser::NumberedLine line; next != open.end() && lines.next(line);) {
      take(line);
    }
  }
}

}  // namespace

void fill_in_blocks(std::vector<Diagnostic>& diagnostics, ProgramFile& program) {
  std::map<std::string, Open> files;
  for (Diagnostic& diagnostic : diagnostics) {
    if (diagnostic.block.text.empty() && diagnostic.source.column > 0) {
      files[diagnostic.file].push_back(&diagnostic);
    }
  }
  for (const auto& [name, open] : files) {
    if (name.empty()) {
      fill_in(open, program);
    } else if (auto subprogram = ProgramFile::open(name)) {
      fill_in(open, *subprogram);
    }
  }
}

}  // namespace kerf::program
