// What is wrong with a program, and what it would do, before anything moves: check FILE.
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

#include <kerf/kerf.hpp>

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "check FILE\n");
    return 2;
  }
  std::ifstream file(argv[1], std::ios::binary);
  if (!file) {
    std::fprintf(stderr, "%s cannot be read\n", argv[1]);
    return 2;
  }
  const std::string text{std::istreambuf_iterator<char>(file), {}};

  // The program may come in pieces of any size; an empty one is its end.
  std::string_view rest = text;
  const auto next_piece = [&rest] {
    const std::string_view piece = rest.substr(0, 4096);
    rest.remove_prefix(piece.size());
    return piece;
  };
  const kerf::CheckReport report = kerf::check_program(next_piece, kerf::default_machine());
  for (const auto* list : {&report.diagnostics, &report.limit_faults}) {
    for (const kerf::Diagnostic& diagnostic : *list) {
      std::printf("%s\n", to_text(diagnostic, argv[1]).c_str());
    }
  }
  if (report.moves) {
    for (std::size_t k = 0; k < 3; ++k) {
      std::printf("%c %.3f to %.3f mm\n", "xyz"[k], report.extents.min_mm[k],
                  report.extents.max_mm[k]);
    }
  }
  return report.has_errors() || !report.limit_faults.empty() ? 1 : 0;
}
