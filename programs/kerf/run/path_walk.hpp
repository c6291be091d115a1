// The path of a file that is run, from its begin on.
#pragma once

#include <string>

#include <tl/expected.hpp>

#include "kernel/program_path.hpp"
#include "programs/kerf/io/interrupt.hpp"
#include "programs/kerf/io/program_file.hpp"

namespace kerf::program {

// Gives each output to on_output, until that says false, the path ends or a signal comes. True: the
// path has ended. Error: the file cannot be read.
template <typename OnOutput>
tl::expected<bool, std::string> walk_path(ProgramFile& file, ProgramPath& path,
                                          const OnOutput& on_output) {
  ProgramPath::Output output;
  while (!stop_requested()) {
    switch (path.next(output)) {
      case ProgramPath::Next::output:
        if (!on_output(output)) {
          return false;
        }
        break;
      case ProgramPath::Next::ended:
        return true;
      case ProgramPath::Next::wants_text: {
        const auto piece = file.read();
        if (!piece) {
          return tl::unexpected(piece.error());
        }
        if (piece->empty()) {
          path.finish();
        } else {
          path.feed(*piece);
        }
      }
    }
  }
  return false;
}

}  // namespace kerf::program
